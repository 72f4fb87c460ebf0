"""glTF 2.0 files in, as text (.gltf) and binary (.glb): scenes of nodes that place meshes.

Source: Khronos Group, glTF 2.0 Specification, 2.0.1 (ISO/IEC 12113).
"""
