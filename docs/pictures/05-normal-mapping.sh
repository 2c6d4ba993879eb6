draw --scene inscription
