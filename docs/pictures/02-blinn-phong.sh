draw --scene lights
