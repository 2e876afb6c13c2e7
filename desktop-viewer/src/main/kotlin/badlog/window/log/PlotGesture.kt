package badlog.window.log

import badlog.viewer.session.gesture.PlotDrag

/** A [drag] over the graphs, which began over [graph]; null for the axis and the overview. */
internal data class PlotGesture(val graph: Int?, val drag: PlotDrag)
