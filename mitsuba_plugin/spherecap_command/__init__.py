"""The command ``spherecap``: compare both emitters on a scene, convert a scene, tell what is installed.

The emitter does not need this package; the package ``spherecap`` alone makes it known to Mitsuba.
"""
