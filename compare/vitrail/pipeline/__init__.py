"""The main line of Vitrail, from a scene to verdicts. Begin at ``compare.py``; the values between the stages:

    load      Loaded        scene/load.py       the scene with its places in the file
    prepare   Job           job.py              with its world, its plan and its settings
    lower     Lowered       lowered.py          what each engine reads, and the certificate
    run       Rendering     run.py, run_both.py an image and its run record
    measure   Observed      measurements.py     every number, with its noise
    judge     Results       judge.py            verdicts of all scenes, at one false-alarm rate

``suite.py`` remembers what the scenes of one comparison have come to; ``campaign.py`` runs the tasks of a study;
``scheduler.py`` is how both do several things at a time. ``passes/`` makes one image of many passes; ``score.py``
judges images of other programs; ``accept.py`` makes an image the reference of its scene.
"""
