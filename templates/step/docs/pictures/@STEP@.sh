draw --scene posts
