"""One entry of a certificate as it is written: in certificate.json, in run records and in results.json."""

from __future__ import annotations

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import Record


class CertificateEntry(Record):
    """One parameter's way through the translation: the law meant, the law POV-Ray has, what is left over.

    ``item`` is a part of the scene by its name in backquotes, or a word for what all of it shares. ``residual`` is in
    ``unit``; `relative` is a share of the phenomenon's own size.
    """

    phenomenon: Phenomenon
    item: str
    source_law: str
    target_law: str
    residual: float
    unit: str
    reason: str
