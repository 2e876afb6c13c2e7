package badlog.window.findings

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class FindingsOfSpec : FunSpec({
    test("no program of a file of rules is run") {
        val folder = tempdir().toPath()
        val ran = folder.resolve("ran")
        writeRules(folder, ruleText("A", "A > 5"), "[[hook]]\nname = \"Evil\"\ncommand = \"touch '$ran'\"\n")
        findingsIn(counted(folder)).all.map { it.rule } shouldContainExactly listOf("A")
        Files.exists(ran) shouldBe false
    }
})
