package badlog.core.conformance

import badlog.core.recording.ProblemKind.DUPLICATE_ATTRIBUTE
import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.ProblemKind.INTEGRAL_OVER_GAPS
import badlog.core.recording.ProblemKind.SECOND_X_AXIS
import badlog.core.recording.ProblemKind.UNFIT_ATTRIBUTE
import badlog.core.recording.ProblemKind.UNKNOWN_ATTRIBUTE
import badlog.core.recording.ProblemKind.UNUSUAL_JOIN
import badlog.core.recording.ProblemKind.X_BACKWARDS
import badlog.core.recording.ProblemKind.X_GAPS
import badlog.core.recording.ProblemKind.X_REPEATS
import badlog.core.recording.TopicKind.STATE

/** Attributes: a reader keeps them as they are, and reports their problems when they are applied. */
internal val ATTRIBUTE_CASES = listOf(
    case(
        "all-attributes",
        "Every attribute, where it fits.",
        """{"topics":[{"name":"Time","unit":"s","attrs":["hide","xaxis"]},""" +
            """{"name":"Amps","unit":"A","attrs":["area","zero","delta","differentiate","integrate",""" +
            """"join:Power/All"]},""" +
            """{"name":"Log","unit":"ul","attrs":["log"]}],"values":[]}""" + "\nTime,Amps,Log\n1,12,on\n2,11,off\n",
        bag(
            topic("Time", "s", listOf("hide", "xaxis"), cells = cells(1, 2)),
            topic(
                "Amps",
                "A",
                listOf("area", "zero", "delta", "differentiate", "integrate", "join:Power/All"),
                cells = cells(12, 11),
            ),
            topic("Log", attributes = listOf("log"), kind = STATE, cells = cells("on", "off")),
        ),
    ),
    case(
        "odd-attributes",
        "Unknown attributes are kept and reported, duplicates too; an empty one is ignored.",
        powerBag("""["zero","smooth:5","zero",""]""", "1,12\n"),
        bag(
            time(1),
            topic("Volts", "V", listOf("zero", "smooth:5", "zero", ""), cells = cells(12)),
            attributeProblems = listOf(UNKNOWN_ATTRIBUTE of "Volts", DUPLICATE_ATTRIBUTE of "Volts"),
        ),
    ),
    case(
        "log-beside-others",
        "An event log has no line to fill.",
        powerBag("""["log","area"]""", "1,on\n"),
        bag(
            time(1),
            topic("Volts", "V", listOf("log", "area"), kind = STATE, cells = cells("on")),
            attributeProblems = listOf(UNFIT_ATTRIBUTE of "Volts"),
        ),
    ),
    case(
        "two-x-axes",
        "The first one wins.",
        powerBag("""["xaxis"]""", "1,12\n", """["xaxis"]"""),
        bag(
            topic("Time", "s", listOf("xaxis"), cells = cells(1)),
            topic("Volts", "V", listOf("xaxis"), cells = cells(12)),
            attributeProblems = listOf(SECOND_X_AXIS of "Volts"),
        ),
    ),
    case(
        "x-backwards",
        "The robot's clock was set: x goes back and repeats. All samples are kept.",
        powerBag("""["differentiate"]""", "5,12\n6,11\n1,10\n1,9\n2,8\n", """["xaxis"]"""),
        bag(
            topic("Time", "s", listOf("xaxis"), cells = cells(5, 6, 1, 1, 2)),
            topic("Volts", "V", listOf("differentiate"), cells = cells(12, 11, 10, 9, 8)),
            attributeProblems = listOf(X_BACKWARDS of "Time", X_REPEATS of "Time"),
        ),
    ),
    case(
        "gaps",
        "Gaps in x cannot be drawn; an integral carries on over those in y.",
        powerBag("""["integrate"]""", "1,12\n,11\n3,\n4,9\n5,8\n", """["xaxis"]"""),
        bag(
            topic("Time", "s", listOf("xaxis"), cells = cells(1, null, 3, 4, 5)),
            topic("Volts", "V", listOf("integrate"), cells = cells(12, 11, null, 9, 8)),
            problems = listOf(EMPTY_CELLS of "Time", EMPTY_CELLS of "Volts"),
            attributeProblems = listOf(X_GAPS of "Time", INTEGRAL_OVER_GAPS of "Volts"),
        ),
    ),
    case(
        "joins",
        "A graph of several units, and one that is a topic's own: drawn, and reported.",
        """{"topics":[{"name":"A","unit":"V","attrs":["join:All"]},{"name":"B","unit":"A","attrs":["join:All"]},""" +
            """{"name":"C","unit":"V","attrs":["join:A"]}],"values":[]}""" + "\nA,B,C\n1,2,3\n",
        bag(
            topic("A", "V", listOf("join:All"), cells = cells(1)),
            topic("B", "A", listOf("join:All"), cells = cells(2)),
            topic("C", "V", listOf("join:A"), cells = cells(3)),
            attributeProblems = listOf(UNUSUAL_JOIN of "B", UNUSUAL_JOIN of "C"),
        ),
    ),
)

private fun powerBag(attributes: String, rows: String, timeAttributes: String = "[]") = """{"topics":[{"name":"Time","unit":"s","attrs":$timeAttributes},""" +
    """{"name":"Volts","unit":"V","attrs":$attributes}],"values":[]}""" + "\nTime,Volts\n$rows"
