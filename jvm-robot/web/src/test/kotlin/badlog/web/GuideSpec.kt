package badlog.web

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import java.io.File

class GuideSpec : FunSpec({
    test("the lines in docs/web.md equal the compiled ones") {
        val guide = File("../../docs/web.md").readText()
        val examples = guide.split("```java\n").drop(1).map { it.substringBefore("```") }.filter { "LogServer" in it }
        val compiled = File("src/test/java/badlog/robots/ServingRobot.java").readLines().map { it.trim() }
        examples.size shouldBe 2
        compiled shouldContainAll examples.flatMap { it.trim().lines() }.map { it.substringBefore("  //").trim() }
    }
})
