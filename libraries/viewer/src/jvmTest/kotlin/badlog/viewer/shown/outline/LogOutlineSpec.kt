package badlog.viewer.shown.outline

import badlog.core.analysis.LogView
import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll

/** A topic of a type, with samples from 1 to [to]. */
private fun topic(name: String, type: String = "double", to: Double = 2.0, unit: String = ""): Topic = timedTopic(name, 0.0 to 1.0, 4.0 to to).copy(type = type, unit = unit)

private fun flag(name: String): Topic = topic(name, "boolean[]").copy(counts = CellCounts(0, 0, 2, 0, 0, 0), samples = doubleArrayOf(0.0, 1.0))

private fun empty(name: String) = Topic(name, "", emptyList(), DoubleArray(0), TextColumn.EMPTY, CellCounts(0, 0, 0, 0, 0, 0), DoubleArray(0))

/** A log that is large because it has many settings besides [topics]. */
private fun large(vararg topics: Topic): LogView = timedView(*topics, *Array(100) { topic("Settings/Gain $it", to = 1.0) })

private fun drawn(view: LogView) = outlineOf(view, RuleSet.BUILT_IN.signals).folders.flatMap { it.folder.graphs }
    .map { graph -> graph.name to graph.series.map { it.topic.name } }

class LogOutlineSpec : FunSpec({
    test("a log that a person can look through shows all graphs that its attributes define") {
        val view = timedView(topic("A"), topic("Still", to = 1.0), empty("Nothing"))
        val outline = outlineOf(view, RuleSet.BUILT_IN.signals)
        outline.folders.map { it.folder } shouldBe view.folders
        outline.constants shouldBe emptyList()
        outline.empty shouldBe emptyList()
    }

    test("in a large log, a constant topic is a row with its value, and an empty one only a name") {
        val outline = outlineOf(large(topic("A"), empty("Nothing")), RuleSet.BUILT_IN.signals)
        outline.folders.flatMap { it.folder.graphs }.map { it.name } shouldBe listOf("A")
        outline.constants.size shouldBe 100
        outline.constants[3].run { name to text } shouldBe ("Settings/Gain 3" to "1")
        outline.empty.map { it.name } shouldBe listOf("Nothing")
    }

    test("the numbers of an array share a graph, and its states another") {
        val view = large(topic("DS/axes[0]", "float[]"), topic("DS/axes[1]", "float[]", to = 1.0), flag("DS/buttons[0]"), flag("DS/buttons[1]"))
        drawn(view) shouldBe listOf("DS/axes" to listOf("DS/axes[0]", "DS/axes[1]"), "DS/buttons" to listOf("DS/buttons[0]", "DS/buttons[1]"))
    }

    test("x, y and angle of a pose share a graph, and so do the speeds of a chassis") {
        val pose = listOf("translation/x", "translation/y", "rotation/value").map { topic("Drive/Pose/$it", "struct:Pose2d") }
        val speeds = listOf("vx", "vy", "omega").map { topic("Drive/Speeds/$it", "struct:ChassisSpeeds") }
        drawn(large(*(pose + speeds).toTypedArray())) shouldBe
            listOf("Drive/Pose" to pose.map { it.name }, "Drive/Speeds" to speeds.map { it.name })
    }

    test("the speeds of all swerve modules share a graph with their targets, and their angles another") {
        val states = listOf("Measured", "Setpoints").flatMap { side ->
            List(4) { it }.flatMap { i -> listOf("speed", "angle/value").map { "Swerve/$side[$i]/$it" } }
        }
        val view = large(*states.map { topic(it, "struct:SwerveModuleState[]") }.toTypedArray())
        drawn(view) shouldBe listOf(
            "Swerve/Module speeds" to states.filter { it.endsWith("speed") },
            "Swerve/Module angles" to states.filter { it.endsWith("value") },
        )
    }

    test("target and actual of one thing share a graph, even if the target never changes") {
        drawn(large(topic("Arm/TargetAngle", to = 1.0), topic("Arm/ActualAngle"))) shouldBe
            listOf("Arm/ActualAngle" to listOf("Arm/ActualAngle", "Arm/TargetAngle"))
        drawn(large(topic("Arm/Goal", unit = "deg"), topic("Arm/Angle", unit = "deg"))) shouldBe
            listOf("Arm/Angle" to listOf("Arm/Angle", "Arm/Goal"))
    }

    test("a target in another unit, or without a clear actual value, stays alone") {
        drawn(large(topic("Arm/TargetAngle", unit = "deg"), topic("Arm/Angle", unit = "rad"))).size shouldBe 2
        drawn(large(topic("Arm/Goal"), topic("Arm/Angle"), topic("Arm/Velocity"))).size shouldBe 3
    }

    test("with too many graphs to look through, graphs of signals are first, and the others are listed in their folders") {
        val view = large(*Array(90) { topic("Folder ${it % 9}/Value $it") }, topic("SystemStats/BatteryVoltage"))
        val outline = outlineOf(view, RuleSet.BUILT_IN.signals)
        outline.folders.sumOf { it.folder.graphs.size } shouldBe 36
        outline.folders.flatMap { it.folder.graphs }.map { it.name } shouldContain "SystemStats/BatteryVoltage"
        outline.folders.sumOf { it.listed.size } shouldBe 55
    }

    test("kept topics are drawn unchanged") {
        val view = large(topic("Kept", to = 1.0), topic("Arm/Target"), topic("Arm/Actual"))
        outlineOf(view, RuleSet.BUILT_IN.signals, setOf("Kept", "Arm/Target")).folders.flatMap { it.folder.graphs }.map { it.name } shouldBe
            listOf("Kept", "Arm/Target", "Arm/Actual")
    }

    test("each topic of any log is drawn, listed, constant or empty, and at most sixty graphs are drawn") {
        val parts = Arb.element("Arm", "Drive", "target", "Actual", "axes[0]", "axes[1]", "3", "speed", "translation", "x", "Setpoint", "angle", "")
        val names = Arb.list(parts, 1..4).map { it.joinToString("/") }
        val types = Arb.element("double", "float[]", "struct:Pose2d", "struct:SwerveModuleState[]", "boolean", "")
        checkAll(30, Arb.list(Arb.pair(names, Arb.pair(types, Arb.int(0..3))), 0..250)) { described ->
            val topics = described.distinctBy { it.first }.map { (name, content) ->
                val (type, kind) = content
                when (kind) {
                    0 -> empty(name)
                    1 -> topic(name, type, to = 1.0)
                    2 -> flag(name)
                    else -> topic(name, type)
                }
            }
            val view = timedView(*topics.toTypedArray())
            val outline = outlineOf(view, RuleSet.BUILT_IN.signals)
            val graphs = outline.folders.flatMap { it.folder.graphs }
            graphs.size shouldBeLessThanOrEqual MAX_SHOWN_GRAPHS
            for (graph in graphs) graph.series.size shouldBeLessThanOrEqual MAX_LINES
            val shown = (graphs + outline.folders.flatMap { it.listed }).flatMap { it.series }.map { it.topic.name }
            shown + outline.constants.map { it.name } + outline.empty.map { it.name } shouldContainExactlyInAnyOrder topics.map { it.name }
        }
    }

    test("a topic is shown with the target or actual of the same thing") {
        val view = timedView(topic("Arm/TargetAngle"), topic("Arm/ActualAngle"), topic("Arm/Other"))
        withCounterparts(view, "Arm/TargetAngle") shouldBe listOf("Arm/ActualAngle", "Arm/TargetAngle")
        withCounterparts(view, "Arm/ActualAngle") shouldBe listOf("Arm/ActualAngle", "Arm/TargetAngle")
        withCounterparts(view, "Arm/Other") shouldBe listOf("Arm/Other")
    }
})
