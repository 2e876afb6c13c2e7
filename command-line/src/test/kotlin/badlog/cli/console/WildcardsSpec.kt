package badlog.cli.console

import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.writeText

private const val WINDOWS = "Windows 11"

/** The error that follows if Java on Windows rejects [path]. */
private fun noPath(path: String): String {
    val at = path.indexOfAny(charArrayOf('*', '?'))
    return "Usage: badlog info [OPTIONS] [FILE]\n\nError: invalid value for FILE: Illegal char <${path[at]}> at index $at: $path"
}

class WildcardsSpec : FunSpec({
    test("on Windows, a pattern in quotes is the files that match it, whatever their case, in order") {
        inFolder { folder ->
            for (name in listOf("b.bag", "A.BAG", "c.wpilog")) (folder / name).writeText("")
            withWildcards(listOf("info", "$folder/*.bag"), WINDOWS) shouldContainExactly listOf("info", "$folder/A.BAG", "$folder/b.bag")
        }
    }

    test("an expression, an option, a pattern without files and one in a folder that does not exist stay as they are") {
        inFolder { folder ->
            (folder / "a.bag").writeText("")
            val arguments = listOf("$folder/a.bag", "max(\"PDP/*\") > 3 * 2", "--*", "$folder/x*.bag", "$folder/none/*.bag")
            withWildcards(arguments, WINDOWS) shouldBe arguments
        }
    }

    test("on other systems the shell expands patterns, and * is a letter of a name") {
        inFolder { folder ->
            (folder / "a.bag").writeText("")
            withWildcards(listOf("$folder/*.bag"), "Linux") shouldContainExactly listOf("$folder/*.bag")
        }
    }

    test("a name with letters that Windows replaced finds the only matching file, or the error says to name its folder") {
        inFolder { folder ->
            (folder / "лог.bag").writeText("")
            withWildcards(listOf("$folder/???.bag"), WINDOWS) shouldContainExactly listOf("$folder/лог.bag")
            (folder / "abc.bag").writeText("")
            val arguments = listOf("info", "$folder/???.bag")
            withWildcards(arguments, WINDOWS) shouldBe arguments
            val failure = noPath("$folder/???.bag")
            unreachable(arguments, failure, WINDOWS).shouldNotBeNull() shouldContain "name the folder above it"
            unreachable(arguments, failure, "Linux") shouldBe null
            unreachable(listOf("info", "a.bag"), failure, WINDOWS) shouldBe null
            val none = listOf("info", "$folder/*.wpilog")
            withWildcards(none, WINDOWS) shouldBe none
            unreachable(none, noPath("$folder/*.wpilog"), WINDOWS) shouldBe "There is no file or folder $folder/*.wpilog; check the spelling."
        }
    }

    test("the error names the argument that is not a path, not a formula before it") {
        val arguments = listOf("find", "max(Speed) > 3 * 2", "logs/my *.wpilog", "*")
        unreachable(arguments, noPath("logs/my *.wpilog"), WINDOWS) shouldBe "There is no file or folder logs/my *.wpilog; check the spelling."
        unreachable(arguments, noPath("logs/my\n*.wpilog"), WINDOWS) shouldBe "There is no file or folder logs/my *.wpilog; check the spelling."
        unreachable(arguments, "Error: missing argument FILE", WINDOWS) shouldBe null
    }

    test("Windows' prefix for long paths is removed") {
        val arguments = listOf("info", """\\?\C:\logs\a.bag""", """\\?\UNC\pit\logs\b.bag""", """--out=\\?\D:\out""")
        withWildcards(arguments, WINDOWS) shouldContainExactly listOf("info", """C:\logs\a.bag""", """\\pit\logs\b.bag""", """--out=D:\out""")
        withWildcards(arguments, "Linux") shouldBe arguments
    }
})
