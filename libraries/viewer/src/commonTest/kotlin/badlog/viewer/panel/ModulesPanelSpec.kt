package badlog.viewer.panel

import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.state.PlaceAction
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlin.math.PI

class ModulesPanelSpec : FunSpec({
    val times = List(501) { it / 50.0 }

    /** Ten seconds of three modules; module 1 points 10° aside, and 15° from 3 s to 3.5 s. */
    fun drive(vararg sides: String): SwerveDrive {
        val topics = sides.flatMap { side ->
            List(3) { module ->
                fun line(name: String, value: (Double) -> Double): Topic = timedTopic("$side[$module]/$name", *times.map { it to value(it) }.toTypedArray())
                val isAside = module == 1 && side == "Measured"
                listOf(line("speed") { 2.0 }, line("angle/value") { it / 5 + if (!isAside) 0.0 else (if (it in 3.0..3.5) 15 else 10) * PI / 180 })
            }.flatten()
        }
        return SwerveDrive.of(timedView(*topics.toTypedArray()))!!
    }

    fun panel(drive: SwerveDrive) = modulesPanel(drive, drive.errors?.within(Span(0.0, 10.0)).orEmpty(), { "${it.toInt()} s" }, DrivePicture(drive, drive.errors)) { _, _, _ -> }

    test("the worst module is named, and each module has its errors, with a way to the largest") {
        val parts = panel(drive("Measured", "Setpoints"))
        (parts[0] as Paragraph).text shouldStartWith "Module 1 has the largest angle error: 10.3° RMS"
        (parts[1] as Picture).name shouldBe "Modules at the cursor"
        val rows = parts.filterIsInstance<Table>().single().rows
        rows.flatMap { it.cells[0] }.map { it.text to it.color } shouldContainExactly List(3) { "Module $it" to it }
        val go = rows.filter { it.name == "Module 1" }[0].cells[2].single()
        go.hint shouldBe "largest 15.0°: Go to the largest error, at 3 s"
        (go.open as PlaceAction.GoTo).x shouldBe 3.0
    }

    test("without targets, the reason replaces the errors") {
        val parts = panel(drive("Measured"))
        (parts[0] as Paragraph).text shouldContain "no targets"
        parts.filterIsInstance<Table>().size shouldBe 0
    }
})
