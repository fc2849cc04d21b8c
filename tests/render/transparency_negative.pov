// filter and transmit below 0 turn colours behind them into their opposites;
// so does the light of dark colours. Two of them give the colour back.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
light_source { <3, 4, -20> rgb 1 }
sky_sphere {
    pigment { gradient x color_map { [0 rgb <.4, .6, .8>] [1 rgb x] } }
}
#macro Pane(Row, P)
    box {
        <I - 4, Row - 3, 0>, <I - 3, Row - 2, .01>
        pigment { P }
        finish { ambient 0 emission .4 diffuse .6 }
    }
#end
#declare I = 0;
#while (I < 8)
    Pane(5, pigment { rgb .5 transmit -I * .3 })
    Pane(4, pigment { rgb .9 transmit -I * .01 })
    Pane(3, pigment { rgb .5 filter -I * .3 })
    Pane(2, pigment { rgb <.5, .9, .2> filter I * .2 transmit -I * .1 })
    Pane(1, pigment { rgb <.5, .9, .2> filter -I * .2 transmit I * .1 })
    Pane(0, pigment { rgb <-I, 1, .2> filter .5 })
    #declare I = I + 1;
#end
