package badlog.window.log

import badlog.viewer.session.gesture.PlotDrag

/** A [drag] that began over [graph]. If [graph] is null, it began over the axis or the overview. */
internal data class PlotGesture(val graph: Int?, val drag: PlotDrag)
