package badlog.release.tasks

import badlog.release.tempFolder
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

class WalkSpec : FunSpec({
    val project = tempFolder()
    val guide = "# A\n\n## Five tasks\n\nText.\n\n### Add a key\n\n1. In [`Keys`](a/Keys.kt), or [there](b/Gone.kt#top).\n\n### Add a rule\n\n## Habits\n\n[x](y)\n"

    fun walk() = Walk(project, guidedTasksIn(guide).first())

    test("the tasks of a guide have the files that they link") {
        guidedTasksIn(guide).map { it.title to it.files } shouldBe
            listOf("Add a key" to mapOf("Keys" to "a/Keys.kt", "there" to "b/Gone.kt"), "Add a rule" to emptyMap())
    }

    test("a file that the guide does not name cannot be changed") {
        shouldThrow<IllegalStateException> { walk().insert("Reduce", "a", "b") }.message shouldContain "does not name Reduce"
    }

    test("a named file that does not exist is reported") {
        shouldThrow<IllegalStateException> { walk().named("there") }.message shouldContain "names b/Gone.kt, which does not exist"
    }

    test("a named file is changed at one place, and the others are unused") {
        val file = File(project, "a/Keys.kt").apply { parentFile.mkdirs() }
        file.writeText("one two")
        val walk = walk()
        walk.insert("Keys", "one", " and")
        file.readText() shouldBe "one and two"
        walk.unused shouldBe setOf("there")
        shouldThrow<IllegalStateException> { walk.insert("Keys", "three", "") }
    }
})
