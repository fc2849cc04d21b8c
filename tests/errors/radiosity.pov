global_settings { radiosity { counts 100 } }
