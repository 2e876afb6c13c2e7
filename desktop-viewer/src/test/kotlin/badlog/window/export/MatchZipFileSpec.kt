package badlog.window.export

import badlog.window.choice.stationBeside
import badlog.window.log.OpenRecording
import badlog.window.putPair
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

class MatchZipFileSpec : FunSpec({
    test("a match as a ZIP opens as the log that was shown, at the same times") {
        val folder = tempdir().toPath()
        val robot = OpenRecording.read(putPair(folder))
        val shown = robot.with(robot.choices.copy(station = stationBeside(robot, folder).shouldNotBeNull()))
        val target = folder.resolve("match.zip").toAbsolutePath()
        matchZipFile(shown, target) shouldStartWith "Wrote robot.bag and 2026_03_07 10_04_05 Sat.dslog to $target"
        val opened = OpenRecording.read(target)
        fun volts(open: OpenRecording) = open.view.recording.topics.single { it.name == "Driver Station/Battery Voltage" }.run {
            // A WPILOG has times in microseconds.
            checkNotNull(times).map { Math.round(it * 1e4) }.zip(samples.toList()).takeLast(300)
        }
        volts(opened) shouldBe volts(shown)
        opened.view.recording.topics.single { it.name == "Arm/Angle" }.samples.toList() shouldBe List(600) { it % 90.0 }
    }
})
