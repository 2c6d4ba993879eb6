draw --scene lantern --set view.turn=30
