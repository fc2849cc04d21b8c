union { sphere { 0, 1 } box { 0, 1 } }, sphere { 0, 2 }
sphere { 0, 1 } */
-- a comment
# another comment
sphere { 0, 1 } - box { 0, 1 }
difference { sphere { 0, 1 } - box { 0, 1 } }
sphere { 0, 1 } translate x
sphere { 0, 1 } no_shadow
version 3.7
