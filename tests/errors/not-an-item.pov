wombat { 0 }
