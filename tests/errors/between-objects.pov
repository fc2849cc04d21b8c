union { sphere { 0, 1 } box { 0, 1 } }, sphere { 0, 2 }
sphere { 0, 1 } */
sphere { 0, 2 }
-- a comment
# another comment
sphere { 0, 1 } - box { 0, 1 }
difference { sphere { 0, 1 } - box { 0, 1 } }
#macro Ball(R) sphere { 0, R } #end
Ball(1) { translate x }
sphere { 0, 1 } translate x
sphere { 0, 1 } no_shadow
sphere { 0, 1 }
version 3.7
