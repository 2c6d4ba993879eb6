draw @NUMBER@-posts $step --scene posts && single @NUMBER@-posts
