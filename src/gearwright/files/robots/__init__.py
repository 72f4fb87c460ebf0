"""Bodies on joints, as simulators of robots take them: URDF, SDFormat and MuJoCo's MJCF, with meshes beside."""
