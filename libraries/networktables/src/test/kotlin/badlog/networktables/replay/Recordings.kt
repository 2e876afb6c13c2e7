package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser

/** The view of a bag with this text. */
internal fun viewOf(bag: String): LogView {
    val parser = BagParser()
    parser.accept(bag.encodeToByteArray())
    return LogView.of(parser.finish())
}

/** A topic of each kind, in a file with rows that are not evenly spaced. */
internal val VARIED_VIEW: LogView = viewOf(
    """
    {"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Arm/Angle","unit":"deg","attrs":[]},{"name":"Arm/At Top","unit":"ul","attrs":[]},{"name":"Arm/State","unit":"ul","attrs":[]},{"name":"Log","unit":"ul","attrs":["log"]},{"name":"Nothing","unit":"A","attrs":[]}],"values":[{"name":"Match Number","value":"8"},{"name":"Arm/Größe","value":""}]}
    Time,Arm/Angle,Arm/At Top,Arm/State,Log,Nothing
    10.00,1.5,false,idle,,
    10.02,2.5,false,rising,up we go,
    10.05,,true,rising,,
    10.06,,true,,again “up”,
    10.10,2.5,true,idle,,
    10.30,4,false,idle,done,
    """.trimIndent() + "\n",
)
