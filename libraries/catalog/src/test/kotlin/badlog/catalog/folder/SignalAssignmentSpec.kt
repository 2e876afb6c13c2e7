package badlog.catalog.folder

import badlog.core.analysis.LogView
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.rules.SignalsFile
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class SignalAssignmentSpec : FunSpec({
    test("changes by another window are kept") {
        val log = tempdir().toPath().resolve("match.csv")
        Files.writeString(log, "Time,Volts,Loop\n0,12,20\n1,12,20\n")
        val view = LogView.of(readRecording(log, LOG_FORMATS))
        val here = SignalAssignment(log, library = null)
        val there = SignalAssignment(log, library = null)
        there.assign("loop time", "Loop", view) shouldBe null
        here.assign("battery", "Volts", view) shouldBe null
        val signals = SignalsFile.parse(Files.readString(here.file))
        for (signal in listOf("loop time", "battery")) signals.find(signal)?.topics?.size shouldBe 1
    }
})
