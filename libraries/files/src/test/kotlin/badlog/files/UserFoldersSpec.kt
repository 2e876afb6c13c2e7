package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.nio.file.Path

class UserFoldersSpec : FunSpec({
    val user = Path.of("/home/of-user").toAbsolutePath()
    val other = Path.of("/home/other").toAbsolutePath()

    fun settings(system: String, vararg variables: Pair<String, String>) = UserFolders.ofSystem(system, user) { variables.toMap()[it] }.settings.parent

    test("HOME takes precedence over the folder in the system's list of users") {
        settings("Linux") shouldBe user.resolve(".config")
        settings("Linux", "HOME" to "$other") shouldBe other.resolve(".config")
        settings("Mac OS X", "HOME" to "$other") shouldBe other.resolve("Library/Application Support")
    }

    test("XDG's variables take precedence over HOME, except relative paths, which XDG ignores") {
        settings("Linux", "HOME" to "/x", "XDG_CONFIG_HOME" to "$other") shouldBe other
        settings("Linux", "XDG_CONFIG_HOME" to "relative") shouldBe user.resolve(".config")
    }
})
