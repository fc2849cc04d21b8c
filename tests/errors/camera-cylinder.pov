camera { cylinder 5 location -z }
