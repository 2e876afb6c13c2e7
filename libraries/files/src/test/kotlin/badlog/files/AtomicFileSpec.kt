package badlog.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.io.InterruptedIOException
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

private fun Path.names() = listDirectoryEntries().map { it.name }.sorted()

class AtomicFileSpec : FunSpec({
    test("a complete file replaces an older one, and its folders are created") {
        inFolder { folder ->
            val file = folder.resolve("deep/er/a.txt")
            writeAtomically(file) { it.write("old".encodeToByteArray()) }
            writeAtomically(file) { out ->
                out.write("new".encodeToByteArray())
                out.flush()
                file.readText() shouldBe "old"
                42
            } shouldBe 42
            file.readText() shouldBe "new"
            file.parent.names() shouldContainExactly listOf("a.txt")
        }
    }

    test("a failure leaves the older file, and no other file beside it") {
        inFolder { folder ->
            val file = folder.resolve("a.txt").apply { writeText("old") }
            shouldThrow<IllegalStateException> {
                writeAtomically(file) {
                    it.write(1)
                    error("enough")
                }
            }
            AtomicFile(file).use { it.out.write(1) }
            file.readText() shouldBe "old"
            folder.names() shouldContainExactly listOf("a.txt")
        }
    }

    test("a file that cannot be written is reported in one sentence, and an interrupt stops the writing") {
        inFolder { folder ->
            val file = folder.resolve("a.txt").apply { writeText("old") }
            val below = file.resolve("b.txt")
            shouldThrow<UnwritableFileException> { writeAtomically(below) {} }.run {
                this.file shouldBe below
                message shouldContain "$below cannot be written: $file is a file, not a folder"
            }
            shouldThrow<UnwritableFileException> { writeAtomically(file) { throw IOException("broken") } }
                .message shouldContain "$file cannot be written (broken)"
            shouldThrow<InterruptedException> { writeAtomically(file) { throw InterruptedIOException() } }
        }
    }
})
