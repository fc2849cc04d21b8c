camera { location 0 look_at 0 }
sphere { 0, 1 }
