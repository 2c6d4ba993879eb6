draw --scene colonnade
