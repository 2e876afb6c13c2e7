package badlog.files.windows

import badlog.files.AtomicFile
import badlog.files.FolderScan
import badlog.files.LogFile
import badlog.files.UnwritableFileException
import badlog.files.safeName
import badlog.files.stationLogsIn
import badlog.files.writeAtomically
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText

private fun Path.names() = listDirectoryEntries().map { it.name }.sorted()

/** Names of a match, an event or a topic that Windows refuses, changes, or takes for a device. */
private val BAD_NAMES = listOf(
    "CON", "con.txt", "NUL", "nul.bag", "AUX", "PRN.wpilog", "COM1", "COM1.bag.gz", "LPT9", "COM¹", "CONIN$",
    "Arm: Angle", "Q42.", "Q42 ", "Q42. .", " Q42", "a/b", "a\\b", "C:", "C:\\x", "\\\\?\\C:\\x", "\\\\.\\NUL", "what?", "a|b", "\"x\"", "<x>", "a*", "..", ".", "",
)

private val DEVICES = setOf("CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$") + "0123456789¹²³".flatMap { listOf("COM$it", "LPT$it") }

class WindowsFilesSpec : FunSpec({
    suspend fun onWindows(work: suspend WindowsFiles.() -> Unit) = WindowsFiles().use { files ->
        files.work()
        files.openCount shouldBe 0
    }

    test("a file replaces an older one, in new folders, also beyond 260 characters") {
        onWindows {
            val deep = (1..20).fold(folder) { path, i -> path.resolve("folder number $i of twenty") }
            val file = deep.resolve("a.txt")
            (file.toString().length > 260) shouldBe true
            for (text in listOf("old", "new")) writeAtomically(file) { it.write(text.encodeToByteArray()) }
            file.readText() shouldBe "new"
            deep.names() shouldContainExactly listOf("a.txt")
        }
    }

    test("a read-only file is not replaced: a sentence has the reason, the old content stays, and no other file is left beside it") {
        onWindows {
            val file = folder.resolve("a.txt")
            writeAtomically(file) { it.write("old".encodeToByteArray()) }
            protect(file)
            shouldThrow<UnwritableFileException> { writeAtomically(file) { it.write("new".encodeToByteArray()) } }.message shouldBe
                "$file cannot be replaced: it is read-only, or another program has it open; make it writable, or close it there."
            file.readText() shouldBe "old"
            folder.names() shouldContainExactly listOf("a.txt")
        }
    }

    test("a file that another program has open is not replaced, but can be once it is closed") {
        onWindows {
            val file = folder.resolve("a.txt")
            writeAtomically(file) { it.write("old".encodeToByteArray()) }
            whileOpen(file) {
                shouldThrow<UnwritableFileException> { writeAtomically(file) { it.write("new".encodeToByteArray()) } }.message shouldBe
                    "$file cannot be written (The process cannot access the file because it is being used by another process); select another place."
                file.readText() shouldBe "old"
                folder.names() shouldContainExactly listOf("a.txt")
            }
            writeAtomically(file) { it.write("new".encodeToByteArray()) }
            file.readText() shouldBe "new"
        }
    }

    test("a file that failed is closed before it is removed: Windows removes no open file") {
        onWindows {
            shouldThrow<IllegalStateException> {
                writeAtomically(folder.resolve("a.txt")) {
                    it.write(1)
                    error("enough")
                }
            }
            AtomicFile(folder.resolve("a.txt")).use { it.out.write(1) }
            folder.names() shouldContainExactly emptyList()
        }
    }

    test("no name of a match, an event or a topic becomes a name that Windows refuses, changes, or takes for a device") {
        onWindows {
            fun expectOrdinary(name: String) {
                val safe = safeName(name)
                val file = folder.resolve(safe)
                file.parent shouldBe folder
                file.name shouldBe safe
                (safe.substringBefore('.').trimEnd(' ').uppercase() in DEVICES) shouldBe false
                (safe.last() in ". ") shouldBe false
                writeAtomically(file) { it.write(1) }
                folder.names() shouldContainExactly listOf(safe)
                Files.delete(file)
            }
            BAD_NAMES.forEach(::expectOrdinary)
            checkAll(Arb.string(0..60)) { expectOrdinary(it) }
        }
    }

    test("logs are found with endings in any case, and keep their names on the disk") {
        onWindows {
            for (name in listOf("Q1.BAG", "FIRST_DS_1.WPILOG", "x.DSLOG", "x.dsevents", "notes.txt")) Files.write(folder.resolve(name), byteArrayOf(1))
            FolderScan.of(folder).files.map(LogFile::name).sorted() shouldContainExactly listOf("FIRST_DS_1.WPILOG", "Q1.BAG", "x.DSLOG")
            stationLogsIn(folder).map(LogFile::name).sorted() shouldContainExactly listOf("FIRST_DS_1.WPILOG", "x.DSLOG")
        }
    }
})
