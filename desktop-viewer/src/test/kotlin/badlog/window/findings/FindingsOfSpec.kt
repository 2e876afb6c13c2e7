package badlog.window.findings

import badlog.window.export.logsIn
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class FindingsOfSpec : FunSpec({
    test("a file of rules cannot run programs") {
        val folder = tempdir().toPath()
        val ran = folder.resolve("ran")
        writeRules(folder, ruleText("A", "A > 5"), "[[hook]]\nname = \"Evil\"\ncommand = \"touch '$ran'\"\n")
        findingsIn(counted(folder)).all.map { it.rule } shouldContainExactly listOf("A")
        Files.exists(ran) shouldBe false
    }

    test("a pack in the folder of logs adds its rules, and its slices are not logs") {
        val folder = tempdir().toPath()
        val log = counted(Files.createDirectories(folder.resolve("day")))
        val pack = folder.resolve("ours.badlog-rules")
        writeRules(pack, ruleText("Half", "A > 50"))
        Files.writeString(Files.createDirectories(pack.resolve("fires/Half")).resolve("slice.bag"), "{}")
        findingsOf(log.view, log.file, folder).all.map { it.rule } shouldContain "Half"
        logsIn(folder) shouldBe emptyList()
    }
})
