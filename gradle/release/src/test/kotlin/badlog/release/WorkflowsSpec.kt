package badlog.release

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

private val WORKFLOWS = File(ROOT, ".github/workflows")

@Tags("InCheck")
class WorkflowsSpec : FunSpec({
    val actionlint = listOf(File(System.getProperty("badlog.actionlint")), found("actionlint")).firstOrNull { it.canExecute() }

    test("actionlint finds no mistake in the workflows").config(
        enabledOrReasonIf = { if (actionlint != null) Enabled.enabled else Enabled.disabled("actionlint is not installed; .ci/install installs it by Go") },
    ) {
        val files = WORKFLOWS.listFiles().orEmpty().map { it.path }.sorted()
        files.map { File(it).name } shouldBe listOf("check.yml", "prove.yml", "release.yml")
        val ended = run(ProcessBuilder(listOf("$actionlint", "-no-color") + files))
        ended.text shouldBe ""
        ended.code shouldBe 0
    }

    test("checks and releases run on Linux, macOS and Windows, on x64 and ARM") {
        for (name in listOf("check.yml", "release.yml")) {
            val text = File(WORKFLOWS, name).readText()
            for (system in listOf("ubuntu-latest", "ubuntu-24.04-arm", "macos-latest", "macos-15-intel", "windows-latest")) {
                // On Linux, everything runs in Debian's container.
                if (name == "release.yml" || system != "ubuntu-latest") text.lines().filterNot { "#" in it }.joinToString() shouldContain system
            }
        }
    }

    test("each download of a release has an attestation, and each system's a bill of materials") {
        val text = File(WORKFLOWS, "release.yml").readText()
        for (part in listOf("actions/attest-build-provenance@", "actions/attest-sbom@", "attestations: write", "id-token: write")) text shouldContain part
    }

    test("workflows that GitHub has never run are marked as such, also in the guide") {
        val isNew = File(ROOT, "docs/releasing.md").readText().contains("have never run")
        for (file in WORKFLOWS.listFiles().orEmpty()) file.readText().contains("# Not yet run:") shouldBe isNew
    }

    test("docs/releasing.md names every secret and variable that the workflows ask for") {
        val asked = WORKFLOWS.listFiles().orEmpty().flatMap { Regex("(?:secrets|vars)\\.([A-Z_]+)").findAll(it.readText()) }.map { it.groupValues[1] }
        val named = Regex("`([A-Z_]+)`").findAll(File(ROOT, "docs/releasing.md").readText()).map { it.groupValues[1] }.toList()
        named shouldContainAll asked.toSet() - "GITHUB_TOKEN"
    }
})
