draw --scene alley
