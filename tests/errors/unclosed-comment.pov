sphere { 0, 1 } /* never /* ends */
