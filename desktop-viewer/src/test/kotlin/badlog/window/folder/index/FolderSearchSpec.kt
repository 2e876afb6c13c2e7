package badlog.window.folder.index

import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.rules.RulesFile
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import kotlinx.coroutines.CancellationException
import java.nio.file.Files

class FolderSearchSpec : FunSpec({
    test("a match that browned out is found, the worst first, with the rules of its folder") {
        val folder = tempdir().toPath()
        folder.putSamples()
        val match = folder.resolve("qualification-42.bag")
        val file = LogFile(match, Files.size(match), 0)
        val found = FolderSearch(folder).found(file) {}
        found.rules.shouldNotBeNull() shouldContain FoundRule("Browned out", Severity.ERROR)
        found.worst shouldBe Severity.ERROR
        found.rules.map { it.severity } shouldBe found.rules.map { it.severity }.sortedDescending()
        found.key shouldBe FolderSearch(folder).keyOf(match)

        Files.writeString(folder.resolve(RulesFile.NAME), "[[rule]]\nname = \"Moved\"\nseverity = \"note\"\nwhen = \"Arm/Angle > -1e9\"\ntext = \"t\"\n")
        val own = FolderSearch(folder).found(file) {}
        own.rules shouldBe listOf(FoundRule("Moved", Severity.NOTE))
        own.key shouldNotBe found.key
    }

    test("a file that cannot be read is not said to have nothing, and who gives up hears so") {
        val folder = tempdir().toPath()
        FolderSearch(folder).found(LogFile(folder.resolve("gone.bag"), 10, 0)) {}.rules.shouldBeNull()
        val log = folder.put("a.bag", bag())
        shouldThrow<CancellationException> { FolderSearch(folder).found(LogFile(log, Files.size(log), 0)) { throw CancellationException() } }
    }
})
