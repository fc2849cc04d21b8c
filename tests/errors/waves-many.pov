global_settings { number_of_waves 100000 }
