camera { cylinder 5 location -z }
camera { omnimax location -z }
