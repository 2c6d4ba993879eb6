draw --scene robot
