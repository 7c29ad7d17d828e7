"""What a scene requires of a renderer, with the evidence and the cost, before anything is rendered.

``analyse`` makes a ``Plan`` from a ``World``; it reads in four steps.

1. *What could happen.* ``possible`` asks the materials alone, wherever the objects are.
2. *What geometry allows.* ``facts`` looks at the world once: ``in_picture`` says what the camera may see,
   ``light_reach`` and ``planes_between`` which light arrives where, ``occlusion`` what may shadow what, ``convexity``
   what never lights or meets itself. From these follow ``light_paths`` (the caustics) and ``chains`` (the longest
   specular chain). Each says no only where it has a proof, by bounds; everything else counts as possible.
3. *Whether it shows.* ``lever`` turns an angle at an object into pixels on the screen, ``intercepted_power`` bounds the
   watts that it turns; what stays below ``stated_error`` is left out, with its size.
4. *The decision.* ``evidence/`` has one function per phenomenon, which answers with a ``Requirement``: words, numbers.

What follows from a plan: ``reduced`` takes out of the scene what the plan does not require; ``budget`` chooses the
``settings`` of a quality, among them the photon radius (``gather_radius``) and the samples of a pixel (``sampling``);
``ablation`` lists what can be switched off to find where two engines part.
"""
