global_settings { radiosity { count 100 } }
