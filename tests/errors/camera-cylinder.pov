camera { cylinder 5 location -z }
camera { fisheye location -z }
