package badlog.signals.match.files

import badlog.core.recording.Value
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.clocked
import badlog.signals.clock.logOf
import badlog.signals.clock.numbers
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private data class Case(val log: ClockedLog, val name: String, val folder: String, val isSame: Boolean)

class NamedAlikeSpec : FunSpec({
    val topics = listOf(numbers("Arm", listOf(0.0 to 1.0, 200.0 to 2.0)))
    val dated = clocked(logOf(topics, "2026-03-07 10:00:00 UTC", listOf(Value("Match Number", "42"), Value("Match Type", "Qualification"))))
    val onlyDated = clocked(logOf(topics, "2026-03-07 10:00:00 UTC"))
    val onlyNumbered = clocked(logOf(topics, null, listOf(Value("Match Number", "42"))))
    val silent = clocked(logOf(topics))

    test("a file belongs to the match with the number or time in its name, or in its folder's name") {
        val cases = listOf(
            Case(dated, "rio_2026-03-07_09-59-30.hoot", "logs", true),
            Case(dated, "rio_2026-03-07_10-03-30.hoot", "logs", true),
            Case(dated, "REV_20260307_100100.revlog", "logs", true),
            // Before the robot's log, and after it.
            Case(dated, "rio_2026-03-07_09-58-30.hoot", "logs", false),
            Case(dated, "rio_2026-03-07_10-05-30.hoot", "logs", false),
            Case(dated, "rio.hoot", "2026-03-07_10-00-30", true),
            Case(dated, "rio.hoot", "MILLC_Q42", true),
            Case(dated, "rio.hoot", "logs", false),
            Case(dated, "Q42.mp4", "videos", true),
            Case(dated, "Q43.mp4", "MILLC_Q42", false),
            Case(dated, "sf42.mp4", "videos", false),
            // The zone of a camera, and another day.
            Case(dated, "2026-03-07_05-00-30 Q42.mp4", "videos", true),
            Case(dated, "2026-03-07_05-00-30.mp4", "videos", false),
            Case(dated, "2026-03-14_10-00-30 Q42.mp4", "videos", false),
            Case(onlyDated, "2026-03-07_10-00-30 Q42.mp4", "videos", true),
            Case(onlyDated, "Q42.mp4", "videos", false),
            Case(onlyNumbered, "Q42.mp4", "videos", true),
            Case(onlyNumbered, "2026-03-07_10-00-30.mp4", "videos", false),
            Case(silent, "2026-03-07_10-00-30 Q42.mp4", "videos", false),
        )
        for (case in cases) withClue(case) { case.log.isNamedAlike(case.name, case.folder) shouldBe case.isSame }
    }
})
