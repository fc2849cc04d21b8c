#error concat("stopped ", "here")
