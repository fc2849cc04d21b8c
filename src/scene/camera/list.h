/* One row for each kind of camera: X(name) stands for name_camera, defined in
 * scene/camera/name.c. */
X(cylinder)
X(fisheye)
X(mesh)
X(omnimax)
X(orthographic)
X(panoramic)
X(perspective)
X(spherical)
X(ultra_wide_angle)
