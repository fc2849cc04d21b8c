sphere { 0, 1 pigment { density_file "a.df3" } }
sphere { 0, 1 pigment { density_file df3 "none.df3" } }
sphere { 0, 1 pigment { density_file df3 "../render/parts/gamma.inc" } }
sphere { 0, 1 pigment { density_file df3 "../render/parts/numbers8.df3"
    interpolate 10 } }
