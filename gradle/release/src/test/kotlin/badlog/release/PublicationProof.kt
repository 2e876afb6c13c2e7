package badlog.release

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import org.w3c.dom.Element
import java.io.File
import java.util.zip.ZipFile
import javax.xml.parsers.DocumentBuilderFactory

private val REPOSITORY = File(ROOT, "build/maven")

class PublicationProof : FunSpec({
    val home = property("badlog.home")
    val poms = REPOSITORY.walk().filter { it.extension == "pom" }.sorted().toList()

    test("every library module is published") {
        val modules = ROOT.walk().maxDepth(4).onEnter { it.name !in listOf("build", ".git", "node_modules") }
            .filter { it.name == "build.gradle" && "gradle/library.gradle" in it.readText() }
            .map { if (it.parentFile.name == "jvm-robot") "badlog-robot" else "badlog-${it.parentFile.name}" }.toList()
        modules shouldContainExactlyInAnyOrder listOf("badlog-core", "badlog-files", "badlog-formats", "badlog-robot", "badlog-web")
        (modules - poms.map { it.name.substringBefore("-$VERSION.pom") }.toSet()).shouldBeEmpty()
    }

    test("a publication has what Maven Central requires: name, description, license, developers, and address once there is one") {
        for (pom in poms) {
            val project = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(pom).documentElement
            val named = listOf("groupId", "artifactId", "version", "name", "description", "licenses", "developers")
            (named + if (home.isEmpty()) emptyList() else listOf("url", "scm")).filter { project.textOf(it).isBlank() }.shouldBeEmpty()
            project.textOf("groupId") shouldBe property("badlog.group")
            if (home.isEmpty()) project.textOf("scm") shouldBe ""
        }
    }

    test("a publication has its sources, and documentation, beside its code") {
        for (pom in poms) {
            val files = pom.parentFile.list().orEmpty().toList()
            val base = pom.name.removeSuffix(".pom")
            for (kind in listOf("sources", "javadoc")) {
                files shouldContain "$base-$kind.jar"
                ZipFile(File(pom.parentFile, "$base-$kind.jar")).use { it.size() shouldBeGreaterThan 1 }
            }
            for (sum in listOf("md5", "sha1")) files shouldContain "${pom.name}.$sum"
        }
    }
})

private fun Element.textOf(child: String): String = (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>().firstOrNull { it.tagName == child }?.textContent?.trim().orEmpty()
