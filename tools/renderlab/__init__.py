"""What the demo and the render tests share: scenes, reference images, error measures, pictures.

Knowledge points one way: this package knows Mitsuba's Python interface and the scenes of the repository, and
nothing of the Rust library, so that its analytic references are independent of the code under test.
"""
