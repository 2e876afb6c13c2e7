package badlog.viewer.draw.path

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.signals.pose.Pose
import badlog.signals.pose.PoseRole
import badlog.signals.pose.posesOf
import badlog.signals.swerve.swerveModulesOf
import badlog.viewer.bagView
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.PI

class XyPlotSpec : FunSpec({
    fun LogView.plot(vararg lines: String) = xyPlotOf(lines.toList(), posesOf(recording.topics)) { name ->
        recording.topics.find { it.name == name }?.let(::seriesOf)
    }

    fun timed(topics: List<Topic>) = timedView(*topics.toTypedArray())

    test("a graph of a pose's x and y is its path on the field, with the robot at the cursor") {
        val view = timed(pathTopics("Pose", Triple(0.0, 2.0, 3.0), Triple(1.0, 4.0, 3.0)))
        val plot = view.plot("Pose/translation/x", "Pose/translation/y")!!
        plot.isField shouldBe true
        plot.full.x.run { from <= 0 && to >= Field.LENGTH } shouldBe true
        val driven = plot.driven!!
        driven.headingAt(0.5) shouldBe (PI / 2 plusOrMinus 1e-12)
        driven.textAt(1.0, isField = true) shouldBe "4.00, 3.00 m · 90°"
        driven.textAt(-1.0, isField = true) shouldBe ""
        // The robot faces up the field: its front is above its middle.
        driven.robotAt(0.0).takeLast(2).map { (it * 100).toInt() / 100.0 } shouldBe listOf(2.0, 3.75)
    }

    test("the numbers of any two other topics at the cursor have six digits, however small they are") {
        val view = timed(listOf(timedTopic("Gain", 0.0 to 0.000123456789), timedTopic("Current", 0.0 to 1234567.0)))
        view.plot("Gain", "Current")!!.traces.single().textAt(0.0, isField = false) shouldBe "0.000123457, 1234567"
    }

    test("a reset of the pose is a gap in the path, and a correction is not") {
        val view = timed(pathTopics("Pose", Triple(0.0, 2.0, 3.0), Triple(0.02, 2.1, 3.0), Triple(0.04, 9.0, 5.0), Triple(0.06, 9.1, 5.0), Triple(0.08, 9.5, 5.0)))
        val driven = view.plot("Pose/translation/x", "Pose/translation/y")!!.driven!!
        driven.trail.x.map { "$it" } shouldBe listOf(2.0, 2.1, Double.NaN, 9.0, 9.1, 9.5).map { "$it" }
        driven.trail.resetsIn(Span(0.0, 1.0)).toList() shouldBe listOf(2.1, 3.0, 9.0, 5.0)
        driven.trail.resetsIn(Span(0.05, 1.0)).toList() shouldBe emptyList()
        // The cursor reads the new place from its time on, and the old one until then.
        driven.textAt(0.04, isField = true) shouldBe "9.00, 5.00 m · 90°"
        driven.textAt(0.039, isField = true) shouldBe "2.10, 3.00 m · 90°"
    }

    test("poses from vision are drawn first, and the driven path last") {
        val names = listOf("Pose", "Target Pose", "Vision/Pose")
        val view = timed(names.flatMap { pathTopics(it, Triple(0.0, 1.0, 1.0)) })
        val plot = view.plot(*names.flatMap { listOf("$it/translation/x", "$it/translation/y") }.toTypedArray())!!
        plot.traces.map { it.role } shouldBe listOf(PoseRole.SEEN, PoseRole.PLANNED, PoseRole.DRIVEN)
        plot.traces.map { it.color } shouldBe listOf(2, 1, 0)
    }

    test("a plan in an array is drawn at the places of its elements at the moment") {
        val view = timed(pathTopics("Trajectory[0]", Triple(0.0, 1.0, 1.0)) + pathTopics("Trajectory[1]", Triple(0.0, 2.0, 2.0), Triple(1.0, Double.NaN, Double.NaN)))
        val plan = view.plot("Trajectory[0]/translation/x", "Trajectory[0]/translation/y")!!.traces.single()
        plan.chainAt(0.5).toList() shouldBe listOf(1.0, 1.0, 2.0, 2.0)
        plan.chainAt(1.0).toList() shouldBe listOf(1.0, 1.0)
    }

    test("before and after a log, its traces have no place, and until its end the last place counts") {
        val names = listOf("Pose", "Target Pose", "Trajectory[0]", "Trajectory[1]")
        val paths = names.flatMap { pathTopics(it, Triple(0.0, 1.0, 2.0), Triple(1.0, 3.0, 2.0)) }
        val view = timed(paths + timedTopic("Voltage", 0.0 to 12.0, 5.0 to 11.0))
        val plot = view.plot(*names.dropLast(1).flatMap { listOf("$it/translation/x", "$it/translation/y") }.toTypedArray())!!
        plot.driven!!.run {
            textAt(5.0, isField = true) shouldBe "3.00, 2.00 m · 90°"
            textAt(5.1, isField = true) shouldBe ""
            robotAt(5.1).size shouldBe 0
        }
        plot.traces.single { it.followers.isNotEmpty() }.run {
            chainAt(5.0).toList() shouldBe listOf(3.0, 2.0, 3.0, 2.0)
            chainAt(5.1).size shouldBe 0
        }
        for (time in listOf(-0.1, 5.1)) plot.marksAt(time, emptySet()) shouldBe emptyList()
        view.plot("Voltage", "Pose/translation/x")!!.traces.single().indexAt(5.1) shouldBe -1
    }

    test("swerve modules are arrows at the robot's corners, with the targets drawn first") {
        fun states(name: String, speed: Double) = List(4) { i ->
            listOf(timedTopic("$name[$i]/speed", 0.0 to speed), timedTopic("$name[$i]/angle/value", 0.0 to 0.0))
        }.flatten().map { it.copy(type = "struct:SwerveModuleState[]") }
        val view = timed(pathTopics("Pose", Triple(0.0, 2.0, 3.0)) + states("Measured", 2.0) + states("Target", 4.0) + states("Rest", 0.0))
        val modules = swerveModulesOf(view.recording.topics)
        modules.map { it.isTarget } shouldBe listOf(false, true, false)
        val plot = xyPlotOf(listOf("Pose/translation/x", "Pose/translation/y"), posesOf(view.recording.topics), modules) { name ->
            view.recording.topics.find { it.name == name }?.let(view::seriesOf)
        }!!
        val arrows = plot.arrowsAt(0.0)
        arrows.map { it.isTarget } shouldBe List(4) { true } + List(4) { false }
        // The robot faces up the field. Its front left corner is at the upper left, and the arrow goes up, by 4 m/s for a quarter of a
        // second.
        arrows[0].places.take(4).zip(listOf(1.7, 3.3, 1.7, 4.3)).forEach { (at, expected) -> at shouldBe (expected plusOrMinus 1e-9) }
        plot.arrowsAt(-1.0) shouldBe emptyList()
    }

    test("three modules are arrows, too: two in front, one behind") {
        val states = List(3) { i -> listOf(timedTopic("Measured[$i]/speed", 0.0 to 4.0), timedTopic("Measured[$i]/angle/value", 0.0 to 0.0)) }
        val view = timed(pathTopics("Pose", Triple(0.0, 2.0, 3.0)) + states.flatten())
        val modules = swerveModulesOf(view.recording.topics)
        val plot = xyPlotOf(listOf("Pose/translation/x", "Pose/translation/y"), posesOf(view.recording.topics), modules) { name ->
            view.recording.topics.find { it.name == name }?.let(view::seriesOf)
        }!!
        plot.arrowsAt(0.0)[2].places.take(4).zip(listOf(2.0, 2.7, 2.0, 3.7)).forEach { (at, expected) -> at shouldBe (expected plusOrMinus 1e-9) }
    }

    test("a moment shows the robot with its center, its plan as an outline, and vision as a dot, but nothing hidden") {
        val names = listOf("Pose", "Target Pose", "Vision/Pose")
        val view = timed(names.flatMap { pathTopics(it, Triple(0.0, 1.0, 2.0)) })
        val plot = view.plot(*names.flatMap { listOf("$it/translation/x", "$it/translation/y") }.toTypedArray())!!
        val marks = plot.marksAt(0.5, emptySet())
        marks.map { it.color } shouldBe listOf(2, 1, 1, 0, 0)
        marks.map { it.isDot } shouldBe listOf(true, false, true, false, true)
        marks.map { it.isFilled } shouldBe listOf(false, false, false, true, false)
        marks[0].places.toList() shouldBe listOf(1.0, 2.0)
        marks[3].isClosed shouldBe true
        plot.marksAt(0.5, setOf("Target Pose/translation/x")).map { it.color } shouldBe listOf(2, 0, 0)
        plot.marksAt(Double.NaN, emptySet()) shouldBe emptyList()
    }

    test("volts and amperes have the same resistance on either axis, also if samples are scattered") {
        val rows = List(50) { "$it,${it * 4},${12 - it * 4 * 0.016 + it % 3 * 0.1}" }
        val view = bagView(listOf("Time|xaxis", "Current", "Voltage"), rows)
        val whole = Span(0.0, 50.0)
        val over = view.plot("Current", "Voltage")!!.lineFit(whole)!!.text("A", "V")
        over.startsWith("Resistance 1") shouldBe true
        view.plot("Voltage", "Current")!!.lineFit(whole)!!.text("V", "A") shouldBe over
    }

    test("other lines are drawn over the first one, and volts over amperes show the resistance") {
        val rows = List(50) { "$it,${it * 4},${12 - it * 4 * 0.016}" }
        val view = bagView(listOf("Time|xaxis", "Current", "Voltage"), rows)
        val plot = view.plot("Current", "Voltage")!!
        plot.isField shouldBe false
        plot.xTitle shouldBe "Current (V)"
        val fit = plot.lineFit(Span(0.0, 50.0))!!
        fit.slope shouldBe (-0.016 plusOrMinus 1e-9)
        fit.text("A", "V") shouldBe "Resistance 16.0 mΩ"
        fit.text("s", "m") shouldBe "Slope -0.0160 m/s"
        plot.lineFit(Span(0.0, 0.5)).shouldBeNull()
        view.plot("Current").shouldBeNull()
        view.plot("Gone", "Voltage").shouldBeNull()
    }

    test("the pointer finds the time of the nearest place on the path, and at a crossing the one nearest to the cursor") {
        val there = List(11) { Triple(it.toDouble(), it.toDouble(), 2.0) }
        val back = List(11) { Triple(11.0 + it, 10.0 - it, 2.0) }
        val view = timed(pathTopics("Pose", *(there + back).toTypedArray()))
        val plot = view.plot("Pose/translation/x", "Pose/translation/y")!!
        fun at(x: Double, y: Double, before: Double?) = plot.timeAt(x, y, 0.1, 0.1, reach = 20.0, Span(0.0, 30.0), before)
        at(3.1, 2.2, null) shouldBe 3.0
        at(3.1, 2.2, 20.0) shouldBe 18.0
        at(3.1, 7.0, null).isNaN() shouldBe true
    }

    test("the robot's departure from its plan is found, but not its stay at the plan's end") {
        val plan = List(100) { Triple(it / 10.0, minOf(it, 60) / 10.0, 2.0) }
        val driven = List(100) { i -> Triple(i / 10.0, minOf(i, 60) / 10.0, if (i >= 40) 2 + (i - 40) / 10.0 else 2.0) }
        val plot = timed(pathTopics("Pose", *driven.toTypedArray()) + pathTopics("Target", *plan.toTypedArray()))
            .plot("Pose/translation/x", "Pose/translation/y", "Target/translation/x", "Target/translation/y")!!
        val left = plot.departure(listOf(Span(0.0, 10.0)), second = 1.0)!!
        left.time shouldBe (4.6 plusOrMinus 1e-9)
        left.farthest shouldBe (2.0 plusOrMinus 1e-9)
        plot.departure(listOf(Span(0.0, 4.5)), second = 1.0).shouldBeNull()
        plot.departure(listOf(Span(7.0, 10.0)), second = 1.0).shouldBeNull()
    }
})
