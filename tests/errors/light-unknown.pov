light_source { 0, 1 spotligth }
