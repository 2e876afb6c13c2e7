package badlog.release

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.File

private val TOOLS = listOf("sh", "dirname", "readlink", "cut", "stty")
private val OWN_JAVA = "badlog-$VERSION-$PLATFORM.tar.gz"

class ProgramProof : FunSpec({
    val folder = tempFolder()
    val java = System.getProperty("java.home")

    test("badlog without Java reports that it needs Java").config(enabledOrReasonIf = CleanMachine.IF_POSSIBLE) {
        val home = unpacked(download("badlog-$VERSION.zip"), File(folder, "zip"))
        val ended = CleanMachine(File(folder, "without-java"), TOOLS).run(listOf("$home/bin/badlog", "--version"))
        ended.code shouldBe 1
        ended.text shouldContain "badlog needs Java 17 or newer, and java is not there"
    }

    test("badlog runs with an installed Java").config(enabledOrReasonIf = CleanMachine.IF_POSSIBLE) {
        val home = unpacked(download("badlog-$VERSION.zip"), File(folder, "installed"))
        shouldWork(home, CleanMachine(File(folder, "with-java"), TOOLS + "$java/bin/java"))
    }

    test("badlog-html with an installed Java writes a page to the file or folder of --out").config(enabledOrReasonIf = CleanMachine.IF_POSSIBLE) {
        val home = unpacked(download("badlog-html-$VERSION.zip"), File(folder, "html"))
        val machine = CleanMachine(File(folder, "html-with-java"), TOOLS + "$java/bin/java")
        val sample = File(ROOT, "samples/qualification-42.bag")
        for (page in listOf(File(folder, "html/page.html"), File(folder, "html/pages/qualification-42.bag.html"))) {
            val out = if (page.parentFile.name == "pages") page.parentFile else page
            machine.run(listOf("$home/bin/badlog-html", "$sample", "--out", "$out")).code shouldBe 0
            page.readText() shouldStartWith "<!DOCTYPE html>"
        }
    }

    test("badlog runs with its own Java if no other is installed").config(enabledOrReasonIf = CleanMachine.IF_POSSIBLE) {
        val home = unpacked(download(OWN_JAVA), File(folder, "own"))
        shouldWork(home, CleanMachine(File(folder, "bare"), TOOLS))
    }

    test("badlog's own Java has each module that its libraries use").config(enabledOrReasonIf = IF_LINUX) {
        val home = unpacked(download(OWN_JAVA), File(folder, "modules"))
        val has = run(ProcessBuilder("$home/java/bin/java", "--list-modules")).text.lines().map { it.substringBefore('@') }
        unpacked(download("badlog-season-$VERSION.zip"), home.parentFile)
        val jars = File(home, "lib").walk().filter { it.extension == "jar" }.toList()
        // One call for all jars, which reads them only once.
        val jdeps = listOf("$java/bin/jdeps", "--multi-release", "17", "--ignore-missing-deps", "--class-path", "$home/lib/*:$home/lib/season/*", "-summary")
        val uses = run(ProcessBuilder(jdeps + jars.map { "$it" })).text.lines().map { it.substringAfter("-> ").trim() }.filter { MODULE.matches(it) }.toSet()
        ("java.base" in uses) shouldBe true
        (uses - has.toSet()).shouldBeEmpty()
    }

    test("man finds the page of each command, and completions are beside the pages").config(enabledOrReasonIf = IF_LINUX) {
        val share = File(unpacked(download("badlog-$VERSION.zip"), File(folder, "manual")), "share")
        File(share, "man/man1/badlog-cut.1").readText() shouldContain "--from".replace("-", "\\-")
        File(share, "completions").list().orEmpty().sorted() shouldBe listOf("badlog.bash", "badlog.fish", "badlog.zsh")
    }
})

/** Checks that the program finds a sample's low battery, reports it, and exports a page. */
private fun shouldWork(home: File, machine: CleanMachine) {
    machine.run(listOf("$home/bin/badlog", "--version")).text shouldBe "badlog $VERSION\n"
    val sample = File(ROOT, "samples/qualification-42.bag")
    val found = machine.run(listOf("$home/bin/badlog", "find", "$sample", "min(battery) < 7", "--json"))
    found.code shouldBe 0
    found.text shouldContain "6.73"
    val page = File(home.parentFile, "match.html")
    machine.run(listOf("$home/bin/badlog", "export", "$sample", "--out", "$page")).code shouldBe 0
    page.readText() shouldStartWith "<!DOCTYPE html>"
}

private val MODULE = Regex("(java|jdk)\\.[a-z.]+")
