package badlog.viewer.draw.path

import badlog.core.analysis.LogView
import badlog.core.recording.Value
import badlog.signals.pose.Trail
import badlog.signals.pose.posesOf
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.PI

class FieldFlipSpec : FunSpec({
    fun view(vararg values: Pair<String, String>): LogView {
        val recording = timedView(*poseTopics("Pose").toTypedArray()).recording
        return LogView.of(recording.copy(values = values.map { (name, text) -> Value(name, text) }))
    }

    fun FieldFlip.of(x: Double, y: Double) = trail(Trail(doubleArrayOf(0.0), doubleArrayOf(x), doubleArrayOf(y))).run { this.x[0] to this.y[0] }

    test("poses are shown as logged, from the red wall, or from the wall of the robot's alliance") {
        val red = view("Alliance" to "Red")
        FieldOrigin.BLUE.flipIn(red).shouldBeNull()
        FieldOrigin.AUTO.flipIn(red).shouldNotBeNull()
        FieldOrigin.AUTO.flipIn(view("Alliance Station" to "Red2")).shouldNotBeNull()
        FieldOrigin.AUTO.flipIn(view("Alliance" to "Blue")).shouldBeNull()
        FieldOrigin.AUTO.flipIn(view()).shouldBeNull()
        FieldOrigin.RED.flipIn(view()).shouldNotBeNull()
    }

    test("poses from the field's center are seen from the red wall: x points to the blue one") {
        val flip = FieldOrigin.CENTER.flipIn(view("Start Time" to "2027-03-16T11:52:30"))!!
        flip.of(0.0, 0.0) shouldBe (Field.LENGTH / 2 to Field.WIDTH / 2)
        flip.of(Field.LENGTH / 2, Field.WIDTH / 2) shouldBe (0.0 to 0.0)
        flip.of(1.0, -2.0) shouldBe (Field.LENGTH / 2 - 1 to Field.WIDTH / 2 + 2)
        flip.heading(0.0) shouldBe (PI plusOrMinus 1e-12)
    }

    test("the fields of 2023 and 2024 are mirrored, others rotated") {
        fun flipped(year: String) = FieldOrigin.RED.flipIn(view("Start Time" to "$year-03-16T11:52:30"))!!.of(1.0, 2.0)
        for (year in listOf("2022", "2025", "2026")) flipped(year) shouldBe (Field.LENGTH - 1 to Field.WIDTH - 2)
        for (year in listOf("2023", "2024")) flipped(year) shouldBe (Field.LENGTH - 1 to 2.0)
        FieldOrigin.RED.flipIn(view())!!.of(1.0, 2.0) shouldBe (Field.LENGTH - 1 to Field.WIDTH - 2)
    }

    test("the path, the heading and the robot at the cursor are seen from the alliance's wall") {
        for ((mirrored, heading) in listOf(true to PI / 2, false to -PI / 2)) {
            val flip = FieldFlip(mirrored)
            flip.heading(PI / 2) shouldBe (heading plusOrMinus 1e-12)
            flip.heading(flip.heading(1.0)) shouldBe (1.0 plusOrMinus 1e-12)
            val view = view()
            val plot = xyPlotOf(listOf("Pose/translation/x", "Pose/translation/y"), posesOf(view.recording.topics), flip = flip) { name ->
                view.recording.topics.find { it.name == name }?.let(view::seriesOf)
            }!!
            plot.driven!!.trail.x[0] shouldBe Field.LENGTH - 1
            plot.driven!!.headingAt(0.0) shouldBe (flip.heading(1.0) plusOrMinus 1e-12)
        }
    }

    test("an arrow of a swerve module is mirrored as the robot is") {
        val arrow = ModuleArrow(doubleArrayOf(1.0, 2.0, 3.0, 4.0), isTarget = false)
        arrow.flipped(FieldFlip(isMirrored = true)).places.toList() shouldBe listOf(Field.LENGTH - 1, 2.0, Field.LENGTH - 3, 4.0)
    }
})
