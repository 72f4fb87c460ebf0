"""3MF files in: a zip package whose XML parts hold meshes, objects made of others, and what is built of them.

Source: 3D Manufacturing Format, Core Specification 1.3, and Production Extension 1.1.
"""
