draw 07-posts $step --scene posts && single 07-posts
