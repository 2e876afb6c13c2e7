package badlog.core.analysis

import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.bag.parse
import badlog.core.recording.ProblemKind
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe

private val TIME = BagTopic("Time", "s", listOf("xaxis", "hide"))

private fun topic(name: String, vararg attributes: String, unit: String = "V") = BagTopic(name, unit, attributes.toList())

/** The view of a bag with these topics; each row has one cell for each, null for an empty one. */
private fun view(
    vararg topics: BagTopic,
    rows: List<List<Any?>> = listOf(List(topics.size) { it + 1.0 }, List(topics.size) { it + 3.0 }),
    values: List<Value> = emptyList(),
    registry: AttributeRegistry = AttributeRegistry.STANDARD,
): LogView {
    val writer = RowWriter().header(BagHeader(topics.toList(), values.map { BagValue(it) }))
    for (row in rows) {
        for (cell in row) {
            when (cell) {
                null -> writer.empty()
                is Double -> writer.number(cell)
                else -> writer.text(cell.toString())
            }
        }
        writer.endRow()
    }
    return LogView.of(parse(writer.bytes.copyOf(writer.size)), registry)
}

private val LogView.graphs get() = folders.flatMap { it.graphs }

private fun LogView.graph(title: String) = graphs.single { it.title == title }

private fun LogView.kinds() = problems.map { it.kind }

class LogViewSpec : FunSpec({
    test("without attributes each topic is a graph over the row index") {
        val view = view(topic("A"), topic("B", unit = "ul"))
        view.xAxis.title shouldBe "Index"
        view.graphs.map { it.title } shouldBe listOf("A", "B")
        view.graph("A").series.single().data.x.toList() shouldBe listOf(0.0, 1.0)
        view.problems.shouldBeEmpty()
    }

    test("xaxis is the x of every other graph and names it with its unit") {
        val view = view(TIME, topic("Arm/Angle"))
        view.xAxis.title shouldBe "Time (s)"
        view.graph("Angle").series.single().data.x.toList() shouldBe listOf(1.0, 3.0)
    }

    test("hide hides the topic's own graph, but not derived graphs") {
        val view = view(TIME, topic("A", "hide", "delta"), topic("B", "hide"))
        view.graphs.map { it.title } shouldBe listOf("[ A Delta ]")
    }

    test("delta, differentiate and integrate add bracketed graphs with derived units, in the order of the attributes") {
        val view = view(TIME, topic("Arm/Angle", "differentiate", "integrate", "delta", unit = "deg"))
        view.graphs.map { it.title to it.unit } shouldBe listOf(
            "Angle" to "deg",
            "[ Angle Derivative ]" to "deg/s",
            "[ Angle Integral ]" to "deg·s",
            "[ Angle Delta ]" to "deg",
        )
        view.graphs.map { it.folder }.toSet() shouldBe setOf("Arm")
        view.graph("[ Angle Derivative ]").series.single().data.y.toList() shouldBe listOf(1.0)
        view.graph("[ Angle Integral ]").series.single().data.y.toList() shouldBe listOf(0.0, 6.0)
    }

    test("x without a unit is Index, and a derivative without a unit is per x") {
        Units.ofDerivative("V", "ul") shouldBe "V/Index"
        Units.ofIntegral("V", "") shouldBe "V·Index"
        Units.ofDerivative("ul", "s") shouldBe "1/s"
        Units.ofIntegral("ul", "s") shouldBe "s"
    }

    test("area and zero show how the topic's own graph is drawn") {
        val view = view(TIME, topic("A", "area", "zero", "delta"))
        view.graph("A").run { isFilled to includesZero } shouldBe (true to true)
        view.graph("[ A Delta ]").run { isFilled to includesZero } shouldBe (false to false)
    }

    test("join adds topics of any folder to one graph, which comes last") {
        val view = view(
            TIME,
            topic("PDP/Current 0", "hide", "join:Power/Currents", unit = "A"),
            topic("Arm/Current", "join:Power/Currents", unit = "A"),
        )
        val joined = view.graph("[ Currents ]")
        joined.folder shouldBe "Power"
        joined.series.map { it.name } shouldBe listOf("Current 0", "Current")
        view.problems.shouldBeEmpty()
    }

    test("joining different units, equal names or a topic's graph works, and is reported as a note") {
        val view = view(
            TIME,
            topic("A/x", "join:G"),
            topic("B/x", "join:G", unit = "A"),
            topic("C"),
            topic("D", "join:C"),
        )
        view.graph("[ G ]").series.map { it.name } shouldBe listOf("x", "x")
        view.graph("C").series.map { it.name } shouldBe listOf("C", "D")
        view.problems.count { it.kind == ProblemKind.UNUSUAL_JOIN } shouldBe 3
    }

    test("log turns texts, but not numbers, into events with the x of their rows") {
        val rows = listOf(listOf(0.5, "on, ready"), listOf(1.5, null), listOf(2.5, 7.0), listOf(3.5, "off"))
        val view = view(TIME, topic("Sys/Log", "log"), rows = rows)
        val log = view.folders.flatMap { it.eventLogs }.single()
        log.title shouldBe "Log"
        log.events.map { it.x to it.text } shouldBe listOf(0.5 to "on, ready", 3.5 to "off")
        view.graphs.shouldBeEmpty()
    }

    test("log beside another attribute is reported and works") {
        val view = view(TIME, topic("Log", "log", "area"), rows = listOf(listOf(0.5, "on")))
        view.folders.flatMap { it.eventLogs }.single().events.size shouldBe 1
        view.kinds() shouldContain ProblemKind.UNFIT_ATTRIBUTE
    }

    test("without an attribute, texts in few rows are events, and in most rows states") {
        val rows = List(6) { listOf(it.toDouble(), if (it == 2) "hit" else null, if (it < 3) "IDLE" else "SHOOT") }
        val view = view(TIME, topic("What"), topic("State"), rows = rows)
        view.folders.flatMap { it.eventLogs }.map { it.name } shouldBe listOf("What")
        val state = view.graph("State").series.single()
        state.states shouldBe listOf("IDLE", "SHOOT")
        state.data.y.toList() shouldBe listOf(0.0, 0.0, 0.0, 1.0, 1.0, 1.0)
        view.graph("State").showsStates shouldBe true
    }

    test("a topic has its events whether or not they are shown") {
        val view = view(TIME, topic("What", "log", "hide"), rows = listOf(listOf(1.5, null), listOf(2.5, "boom")))
        view.folders.flatMap { it.eventLogs }.shouldBeEmpty()
        view.eventsOf(view.recording.topics[1]).events.map { it.x to it.text } shouldBe listOf(2.5 to "boom")
    }

    test("true and false are two states, and numbers where the topic joins a graph") {
        val rows = listOf(listOf(0.0, "true"), listOf(1.0, "false"))
        val view = view(TIME, topic("On", "join:G"), rows = rows)
        view.graph("On").series.single().states shouldBe listOf("false", "true")
        view.graph("[ G ]").showsStates shouldBe false
        view.graph("[ G ]").series.single().data.y.toList() shouldBe listOf(1.0, 0.0)
    }

    test("a topic with a value in fewer than half of its rows has samples of its own times, not gaps") {
        val rows = List(10) { listOf(it.toDouble(), if (it % 5 == 0) it.toDouble() else null) }
        val view = view(TIME, topic("Slow", "differentiate"), rows = rows)
        view.graph("Slow").series.single().data.x.toList() shouldBe listOf(0.0, 5.0)
        view.graph("[ Slow Derivative ]").series.single().data.y.toList() shouldBe listOf(1.0)
    }

    test("a topic with long gaps is not sparse, and no line crosses its gaps") {
        val rows = List(20) { listOf(it.toDouble(), if (it in 5..8 || it in 15..17) 1.0 else null) }
        val series = view(TIME, topic("Target"), rows = rows).graph("Target").series.single().data
        series.size shouldBe 20
        series.y.count { it.isNaN() } shouldBe 13
    }

    test("an integral over gaps is noted") {
        val rows = listOf(listOf(0.0, 1.0), listOf(1.0, null), listOf(2.0, 1.0))
        view(TIME, topic("A", "integrate"), rows = rows).kinds() shouldContain ProblemKind.INTEGRAL_OVER_GAPS
    }

    test("a derived graph with a name that is taken is shown under a free name") {
        val view = view(TIME, topic("A", "differentiate"), topic("A Derivative"), topic("B", "delta", "delta:1"))
        view.graphs.map { it.title } shouldBe
            listOf("A", "[ A Derivative (2) ]", "A Derivative", "B", "[ B Delta ]", "[ B Delta (2) ]")
        view.kinds() shouldBe listOf(ProblemKind.UNFIT_ATTRIBUTE)
    }

    test("unknown and duplicate attributes are noted, empty ones ignored") {
        view(topic("A", "sparkle", "", "zero", "zero")).kinds() shouldBe
            listOf(ProblemKind.UNKNOWN_ATTRIBUTE, ProblemKind.DUPLICATE_ATTRIBUTE)
    }

    test("the first of two x axes is used; the index replaces an x axis of texts") {
        val two = view(TIME, BagTopic("Clock", "ms", listOf("xaxis")))
        two.xAxis.name shouldBe "Time"
        two.kinds() shouldBe listOf(ProblemKind.SECOND_X_AXIS)
        val texts = view(TIME, topic("A"), rows = listOf(listOf("now", 1.0), listOf("later", 2.0)))
        texts.xAxis.title shouldBe "Index"
        texts.kinds() shouldContain ProblemKind.UNFIT_ATTRIBUTE
    }

    test("an x axis that repeats, goes backwards or has gaps is reported, and rows without x are not drawn") {
        val rows = listOf(listOf(0.0, 1.0), listOf(0.0, 2.0), listOf(null, 3.0), listOf(5.0, 4.0), listOf(1.0, 5.0))
        val view = view(TIME, topic("A"), rows = rows)
        view.kinds().filter { it.name.startsWith("X_") } shouldBe
            listOf(ProblemKind.X_BACKWARDS, ProblemKind.X_REPEATS, ProblemKind.X_GAPS)
        view.graph("A").series.single().data.y.toList() shouldBe listOf(1.0, 2.0, 4.0, 5.0)
    }

    test("x values far away from all others are counted and reported, and everything else can be seen") {
        val rows = List(500) { listOf(if (it == 7) 18_447_000_000_000.0 else it * 0.02, 1.0) }
        val view = view(TIME, topic("A"), rows = rows)
        view.xAxis.range shouldBe 0.0..9.98
        view.problems.single { it.kind == ProblemKind.X_WILD }.message shouldBe
            "The x axis “Time” is far off in 1 of 500 rows, such as at 18447000000000; these rows are not drawn. " +
            "Check the robot's clock."
    }

    test("folders are sorted regardless of case, the root first; members keep the order of the file") {
        val view = view(
            topic("zeta/B"),
            topic("zeta/A"),
            topic("Root"),
            topic("Arm/A"),
            topic("arm/B"),
            values = listOf(Value("Match", "8"), Value("Beta/Gain", "0.5")),
        )
        view.folders.map { it.name } shouldBe listOf("", "Arm", "arm", "Beta", "zeta")
        view.folders.last().graphs.map { it.title } shouldBe listOf("B", "A")
        view.folders.first().values.map { it.text } shouldBe listOf("8")
    }

    test("a derivation of texts is reported and skipped") {
        val view = view(TIME, topic("State", "delta", "join:G"), rows = listOf(listOf(0.0, "A"), listOf(1.0, "B")))
        view.graphs.map { it.title } shouldBe listOf("State")
        view.kinds() shouldBe listOf(ProblemKind.UNFIT_ATTRIBUTE, ProblemKind.UNFIT_ATTRIBUTE)
    }

    test("a program can add an attribute of its own") {
        val squared = object : Attribute {
            override val name = "power"

            override fun apply(topic: TopicPlan, argument: String?) {
                topic.derive("Squared $argument", { unit, _ -> "$unit²" }) { series ->
                    Series(series.x, DoubleArray(series.size) { series.y[it] * series.y[it] })
                }
            }
        }
        val view = view(topic("A", "power:2"), registry = AttributeRegistry.STANDARD + squared)
        view.graph("[ A Squared 2 ]").unit shouldBe "V²"
        view.graph("[ A Squared 2 ]").series.single().data.y.toList() shouldBe listOf(1.0, 9.0)
        view.problems.shouldBeEmpty()
    }

    test("event and match values make the title; a log without them has no title") {
        view(
            topic("A"),
            values = listOf(
                Value("Event Name", "OHCL"),
                Value("Match Type", "Qualification"),
                Value("Match_Number", "42"),
            ),
        ).title shouldBe "OHCL Qualification 42"
        view(topic("A"), values = listOf(Value("System/Match Number", "7"))).title shouldBe "Match 7"
        view(topic("A"), values = listOf(Value("Match Type", "None"), Value("Match Number", "0"))).title shouldBe null
    }

    test("a bag without rows has its graphs, without samples") {
        val view = view(TIME, topic("A", "delta"), rows = emptyList())
        view.graphs.map { it.series.single().data.size } shouldBe listOf(0, 0)
    }
})
