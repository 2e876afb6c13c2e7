package badlog.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import java.io.IOException
import java.nio.file.DirectoryIteratorException
import java.nio.file.Files
import kotlin.concurrent.thread

class AppendedLineSpec : FunSpec({
    test("lines that several windows append at the same time are all complete") {
        val file = tempdir().toPath().resolve("lines.jsonl")
        val lines = List(4) { window -> List(100) { "window $window, line $it, ${"x".repeat(it * 7)}" } }
        lines.map { own -> thread { for (line in own) appendLines(file, listOf(line)) } }.forEach { it.join() }
        Files.readAllLines(file).filter { it.isNotEmpty() } shouldContainExactlyInAnyOrder lines.flatten()
    }

    test("lines begin below one that was cut off, and bytes that are not text damage only their place") {
        val file = Files.write(tempdir().toPath().resolve("lines.jsonl"), byteArrayOf('a'.code.toByte(), -1))
        appendLines(file, listOf("b", "c"))
        appendLines(file, listOf("d"))
        appendedText(file) shouldBe "a\uFFFD\nb\nc\nd\n"
    }

    test("a stick that is pulled out while its folder is listed is reported in a sentence") {
        val folder = tempdir().toPath()
        shouldThrow<UnreadableFileException> { reading(folder) { throw DirectoryIteratorException(IOException("gone")) } }.message shouldBe
            "$folder cannot be read (gone); copy it to this computer's disk first."
    }
})
