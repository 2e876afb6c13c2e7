package badlog.lib

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import java.io.File
import java.util.zip.ZipFile

private val FOREIGN = listOf("kotlinx.", "kotlin.coroutines", "edu.wpi.", "org.wpilib.", "org.json.")

@Tags("InCheck")
class ChildRobotSpec : FunSpec({
    test("a robot's jars are sufficient, and it loads no class of coroutines, WPILib or JSON") {
        inFolder { folder ->
            val classes = File(folder, "classes.txt")
            val (exit, output) = run(childCommand(arguments(folder, 100), listOf("-Xlog:class+load:file=$classes")))
            exit to output shouldBe (0 to "")
            val loaded = classes.readLines().map { it.substringAfter("] ").trim().substringBefore(' ') }
            loaded shouldContain "badlog.lib.BadLog"
            loaded.filter { name -> FOREIGN.any { name.startsWith(it) } }.shouldBeEmpty()
        }
    }

    test("each row is one write").config(enabledOrReasonIf = { ifStrace() }) {
        inFolder { folder ->
            val trace = File(folder, "trace.txt")
            val calls = "trace=write,pwrite64,writev,fsync,fdatasync"
            val strace = listOf("strace", "-f", "-y", "-e", calls, "-o", "$trace")
            run(strace + childCommand(arguments(folder, 500))).first shouldBe 0
            val seen = trace.readLines().filter { "test.bag>" in it }
            // One more for the header; the program's end writes nothing.
            seen.count { " write(" in it } shouldBe 501
            val caller = seen.first { " write(" in it }.substringBefore(' ')
            seen.filter { "sync(" in it && it.startsWith("$caller ") }.shouldBeEmpty()
            File(folder, "test.bag").let(::recordingIn).rowCount shouldBe 500
        }
    }

    test("all of a robot's classes are for Java 17 or earlier") {
        val shipped = System.getProperty("badlog.shipped").split(File.pathSeparator).map(::File).filter { it.exists() }
        val versions = shipped.flatMap(::classFilesIn)
        versions.filter { (_, version) -> version > 61 }.shouldBeEmpty()
        versions.filter { (name) -> "badlog/lib/" in name }.map { it.second }.distinct() shouldBe listOf(61)
        shipped.sumOf { place -> place.walk().filter { it.isFile }.sumOf { it.length() } } shouldBeLessThan 2_600_000
    }
})

private fun arguments(folder: File, rows: Int) = listOf("$folder/test.bag", "$rows", "false", "$folder/returned")

private fun ifStrace(): Enabled = when {
    !canRun("strace") -> Enabled.disabled("strace is not installed")
    run(listOf("strace", "-o", "/dev/null", "true")).first != 0 -> Enabled.disabled("strace may not trace here")
    else -> Enabled.enabled
}

/** Returns the name and the major version of each class in a jar or a folder. Skips classes for later releases of Java only. */
private fun classFilesIn(place: File): List<Pair<String, Int>> = if (place.isDirectory) {
    place.walk().filter { it.extension == "class" }.map { it.path to majorVersionOf(it.readBytes()) }.toList()
} else {
    ZipFile(place).use { zip ->
        zip.entries().asSequence()
            .filter { it.name.endsWith(".class") && !it.name.startsWith("META-INF/versions/") }
            .map { it.name to majorVersionOf(zip.getInputStream(it).readNBytes(8)) }
            .toList()
    }
}

private fun majorVersionOf(classFile: ByteArray) = classFile[6].toInt() shl 8 or classFile[7].toInt()
