package badlog.viewer.draw.path

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

class XyPictureSpec : FunSpec({
    val pose = listOf("Pose/translation/x", "Pose/translation/y")
    val amperesAndVolts = listOf("Current", "Voltage")

    fun view(vararg topics: List<Topic>) = timedView(*topics.toList().flatten().toTypedArray())

    fun log(view: LogView, name: String, offset: Double = 0.0) = XyLog(LogPaths(view, Field.PLAIN, BoardLines(view)::get), name, offset)

    /** A robot that drives for 2 s along x from [x], 1 m from the wall. */
    fun drive(x: Double, start: Double = 0.0) = view(pathTopics("Pose", Triple(start, x, 1.0), Triple(start + 1, x + 1, 1.0), Triple(start + 2, x + 2, 1.0)))

    /** The voltages of a battery with this resistance in [ohms]. */
    fun battery(ohms: Double) = timedView(
        timedTopic("Current", *Array(50) { it * 1.0 to it * 4.0 }).copy(unit = "A"),
        timedTopic("Voltage", *Array(50) { it * 1.0 to 12 - it * 4 * ohms }),
    )

    fun picture(lines: List<String>, vararg logs: XyLog) = XyPicture(lines, FieldOrigin.BLUE, logs.toList())

    /** The text of [draw] on a frame of 400 by 200 pixels, primitive by primitive. */
    fun XyPicture.drawn(colors: PenColors = PenColors.LIGHT, draw: XyPicture.(XyFrame) -> Unit): List<String> {
        val pen = SvgPen({ text, letters, _ -> text.length * letters / 2 })
        draw(XyFrame(pen, seen(null, 400.0, 200.0).shouldNotBeNull(), 400.0, 200.0, colors))
        return pen.document(400.0, 200.0, colors[Shade.SURFACE]).split("<")
    }

    fun colorOf(index: Int) = "#" + (PenColors.LIGHT.line(index) and 0xFFFFFF).toString(16).padStart(6, '0')

    test("a single log has the colors and names of its traces, with their places at both cursors") {
        val alone = picture(pose, log(drive(2.0), "Q1"))
        val entry = alone.parts.single().entries.single()
        entry.title shouldBe "Pose"
        entry.log.shouldBeNull()
        entry.color shouldBe 0
        entry.textAt(Cursors()) shouldBe ""
        entry.textAt(Cursors(pinned = 1.0)) shouldBe "3.00, 1.00 m · 90°"
        entry.textAt(Cursors(pinned = 1.0, second = 2.0)) shouldBe "3.00, 1.00 m · 90° → 4.00, 1.00 m · 90°"
        entry.textAt(Cursors(pinned = 1.0, second = 9.0)) shouldBe "3.00, 1.00 m · 90° → –"
        entry.textAt(Cursors(pinned = 8.0, second = 9.0)) shouldBe ""
    }

    test("a compared log has its own colors and its name, and its places at the cursor follow its offset") {
        val both = picture(pose, log(drive(2.0), "Q1"), log(drive(10.0, start = 100.0), "Q2", offset = -100.0))
        val (own, other) = both.parts.map { it.entries.single() }
        listOf(own, other).map { it.title } shouldContainExactly listOf("Pose", "Pose (Q2)")
        listOf(own, other).map { it.log } shouldContainExactly listOf("Q1", "Q2")
        listOf(own, other).map { it.color } shouldContainExactly listOf(0, 1)
        other.textAt(Cursors(pinned = 1.0)) shouldBe "11.00, 1.00 m · 90°"
        both.legend(emptySet(), Cursors(pinned = 2.0)).map { it.text to it.color } shouldContainExactly
            listOf("Pose 4.00, 1.00 m · 90°" to 0, "Pose (Q2) 12.00, 1.00 m · 90°" to 1)
        both.legend(setOf(pose[0]), Cursors()) shouldBe emptyList()
    }

    test("the path of each log has its color, faint outside the visible range, with the robot at the cursor") {
        val both = picture(pose, log(drive(2.0), "Q1"), log(drive(10.0, start = 100.0), "Q2", offset = -99.0))
        fun strokes(visible: Span, color: Int, isFaint: Boolean): Int {
            val drawn = both.drawn { draw(it, emptySet(), visible, ground = null) }
            return drawn.count { "stroke=\"${colorOf(color)}\"" in it && ("stroke-opacity" in it) == isFaint }
        }
        for (color in 0..1) strokes(Span(0.0, 3.0), color, isFaint = false) shouldBe 1
        // All of the open log is visible, but only half of the other one.
        strokes(Span(0.0, 2.0), color = 0, isFaint = true) shouldBe 0
        strokes(Span(0.0, 2.0), color = 1, isFaint = true) shouldBe 1
        fun robots(cursors: Cursors, color: Int) = both.drawn { drawCursors(it, emptySet(), cursors) }.count { "fill=\"${colorOf(color)}\" fill-opacity" in it }
        (0..1).map { robots(Cursors(pinned = 1.5), it) } shouldContainExactly listOf(1, 1)
        // The other log has not begun then.
        (0..1).map { robots(Cursors(pinned = 0.5), it) } shouldContainExactly listOf(1, 0)
    }

    test("the field and the planes show all logs, and only the field keeps its shape") {
        val far = picture(pose, log(drive(2.0), "Q1"), log(drive(20.0), "Q2"))
        far.isField shouldBe true
        far.full.shouldNotBeNull().x.to shouldBe (22.3 plusOrMinus 1e-9)
        val selected = Plane(Span(0.0, 2.0), Span(0.0, 2.0))
        far.seen(selected, 400.0, 200.0).shouldNotBeNull().x shouldBe Span(-1.0, 3.0)
        val batteries = picture(amperesAndVolts, log(battery(0.01), "Q1"), log(battery(0.03), "Q2"))
        batteries.full.shouldNotBeNull().y.from shouldBe (batteries.parts[1].plot.full.y.from plusOrMinus 1e-9)
        batteries.seen(selected, 400.0, 200.0) shouldBe selected
        batteries.seen(Plane(Span(1.0, 1.0), Span(0.0, 1.0)), 400.0, 200.0) shouldBe batteries.full
        picture(listOf("Gone"), log(drive(2.0), "Q1")).run {
            isEmpty shouldBe true
            isField shouldBe false
            seen(selected, 400.0, 200.0).shouldBeNull()
        }
    }

    test("a log without the lines, or without a path, is omitted, and the others keep their colors") {
        fun pair(unit: String) = view(listOf("Pose X", "Pose Y").map { timedTopic(it, 0.0 to 1.0, 1.0 to 2.0).copy(unit = unit) })
        val several = picture(listOf("Pose X", "Pose Y"), log(pair("m"), "Q1"), log(drive(2.0), "Q2"), log(pair("rpm"), "Q3"), log(pair("m"), "Q4"))
        several.parts.map { it.index } shouldContainExactly listOf(0, 3)
        several.legend(emptySet(), Cursors()).map { it.text to it.color } shouldContainExactly listOf("Pose" to 0, "Pose (Q4)" to 3)
    }

    test("the results of two logs are below each other, with the logs' names") {
        val batteries = picture(amperesAndVolts, log(battery(0.01), "Q1"), log(battery(0.03), "Q2"))
        val notes = batteries.drawn { draw(it, emptySet(), Span(0.0, 49.0), ground = null) }.filter { "Resistance" in it }
        notes.map { it.substringAfter('>') } shouldContainExactly listOf("Resistance 10.0 mΩ (Q1)", "Resistance 30.0 mΩ (Q2)")
        val (upper, lower) = notes.map { it.substringAfter(" y=\"").substringBefore('"').toDouble() }
        lower - upper shouldBe (15.0 plusOrMinus 1e-9)
        val alone = picture(amperesAndVolts, log(battery(0.01), "Q1")).drawn { draw(it, emptySet(), Span(0.0, 49.0), ground = null) }
        alone.map { it.substringAfter('>') } shouldContain "Resistance 10.0 mΩ"
    }

    test("a compared robot's departure is reported with the time that the axis shows") {
        fun run(start: Double, leavesAt: Int): LogView {
            val plan = List(100) { Triple(start + it / 10.0, minOf(it, 60) / 10.0, 2.0) }
            val driven = plan.mapIndexed { i, (time, x, _) -> Triple(time, x, if (i >= leavesAt) 2 + (i - leavesAt) / 10.0 else 2.0) }
            return view(pathTopics("Pose", *driven.toTypedArray()), pathTopics("Target", *plan.toTypedArray()))
        }
        val lines = pose + listOf("Target/translation/x", "Target/translation/y")
        val both = picture(lines, log(run(0.0, leavesAt = 40), "Q1"), log(run(100.0, leavesAt = 20), "Q2", offset = -90.0))
        both.drawn { draw(it, emptySet(), Span(0.0, 20.0), ground = null) }.map { it.substringAfter('>') }.filter { "Left" in it } shouldContainExactly
            listOf("Left the plan at 4.600 s, by up to 2.00 m (Q1)", "Left the plan at 12.600 s, by up to 4.00 m (Q2)")
    }

    test("a place belongs to the open log's time where it is drawn") {
        val both = picture(pose, log(drive(2.0), "Q1"), log(drive(10.0), "Q2"))
        fun XyPicture.at(x: Double) = timeAt(x, 1.0, 0.1, 0.1, reach = 5.0, Span(0.0, 20.0), before = null)
        both.at(3.1) shouldBe 1.0
        both.at(11.1).shouldBeNull()
        picture(pose, log(drive(2.0), "Q1", offset = 7.0)).at(3.1) shouldBe 8.0
        picture(listOf("Gone"), log(drive(2.0), "Q1")).at(3.1).shouldBeNull()
    }
})
