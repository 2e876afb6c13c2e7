package badlog.catalog.folder

import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime

class FolderStoreSpec : FunSpec({
    val entries = List(20) { entry("m$it.bag", MatchOfLog("Event", "Final", "$it", "Red"), it * 1000L, topics = List(5) { i -> topic("Arm/$i", i + 0.5) }) } +
        entry("broken.bag", content = Content.UNREADABLE).let { it.copy(summary = it.summary.copy(trouble = "It is broken.", duration = null)) }
    val folder = Path.of("/logs").toAbsolutePath()

    fun filled(cache: Path) = FolderStore(folder, cache, "1").also { store ->
        for (entry in entries) store[entry.source] = entry.summary
        store.save()
    }

    test("stored results are read back unchanged, each text once, for the same folder and version only") {
        val cache = tempdir().toPath().resolve("made/when/needed")
        filled(cache)
        val again = FolderStore(folder, cache, "1")
        entries.map { again[it.source] } shouldBe entries
        again[entries[3].source]!!.summary.topics[2].name shouldBeSameInstanceAs again[entries[4].source]!!.summary.topics[2].name
        FolderStore(Path.of("/other").toAbsolutePath(), cache, "1")[entries[0].source].shouldBeNull()
        FolderStore(folder, cache, "2")[entries[0].source].shouldBeNull()
    }

    test("a changed file has no stored results") {
        val store = filled(tempdir().toPath())
        store[entries[0].source.copy(size = 1)].shouldBeNull()
    }

    test("a store that is cut or has a changed byte is ignored") {
        val cache = tempdir().toPath()
        filled(cache)
        val file = Files.list(cache).use { it.toList() }.single()
        val bytes = Files.readAllBytes(file)
        checkAll(50, Arb.int(bytes.indices)) { at ->
            Files.write(file, bytes.copyOf(at))
            FolderStore(folder, cache, "1")[entries[0].source].shouldBeNull()
            // Readers ignore these bytes of gzip's header, such as its time.
            if (at in 3..9) return@checkAll
            Files.write(file, bytes.clone().also { it[at] = (it[at] + 1).toByte() })
            FolderStore(folder, cache, "1")[entries[0].source].shouldBeNull()
        }
    }

    test("a log is read once for its summary and its findings, and never again") {
        val logs = tempdir().toPath()
        val cache = tempdir().toPath()
        logs.putSamples()
        val file = LogFile.of(logs.resolve("qualification-42.bag"))
        val store = FolderStore(logs, cache, "1")
        val read = LogReading(store).read(file, runsRules = true)
        read.found?.rules.shouldNotBeNull() shouldContain FoundRule("Browned out", Severity.ERROR)
        store.save()
        // A deleted file cannot be read.
        Files.delete(file.path)
        FolderStore(logs, cache, "1")[file] shouldBe read
        LogReading(FolderStore(logs, cache, "1")).found(file) shouldBe read.found
    }

    test("a log that cannot be read now is read again the next time, and something that is not a log is not") {
        val logs = tempdir().toPath()
        val store = FolderStore(logs, tempdir().toPath(), "1")
        val gone = LogFile(logs.resolve("gone.bag"), 10, 0)
        LogReading(store).read(gone, runsRules = true).isReadable shouldBe false
        store[gone].shouldBeNull()
        val diary = LogFile.of(logs.put("diary.csv", "Dear diary\ntoday I was happy\n"))
        LogReading(store).read(diary, runsRules = true).summary.content shouldBe Content.NO_LOG
        store[diary]?.summary?.content shouldBe Content.NO_LOG
    }

    test("two stores that save at the same time keep each other's results") {
        val cache = tempdir().toPath()
        val (one, other) = List(2) { FolderStore(folder, cache, "1") }
        one[entries[0].source] = entries[0].summary
        other[entries[1].source] = entries[1].summary
        one.save()
        other.save()
        val again = FolderStore(folder, cache, "1")
        entries.take(2).map { again[it.source] } shouldBe entries.take(2)
    }
})
