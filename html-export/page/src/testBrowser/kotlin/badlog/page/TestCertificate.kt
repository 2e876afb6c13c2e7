package badlog.page

import java.nio.file.Files
import java.nio.file.Path
import java.security.KeyStore
import java.security.MessageDigest
import java.util.Base64
import javax.net.ssl.KeyManagerFactory
import javax.net.ssl.SSLContext

/** A certificate of this machine, created for the tests and trusted by their Chromium. */
internal object TestCertificate {
    private const val PASSWORD = "badlog"
    private const val NAME = "test"

    private val store: KeyStore by lazy {
        val folder = Files.createTempDirectory("badlog-certificate")
        val file = folder.resolve("keys.p12")
        val keytool = Path.of(System.getProperty("java.home"), "bin", "keytool")
        val command = listOf(
            "$keytool", "-genkeypair", "-alias", NAME, "-keyalg", "EC", "-groupname", "secp256r1", "-dname", "CN=127.0.0.1",
            "-ext", "SAN=ip:127.0.0.1",
            "-storetype", "PKCS12", "-keystore", "$file", "-storepass", PASSWORD,
        )
        val made = ProcessBuilder(command).redirectErrorStream(true).start()
        val output = made.inputStream.readAllBytes().decodeToString()
        check(made.waitFor() == 0) { "No certificate was made: $output" }
        KeyStore.getInstance("PKCS12").apply {
            Files.newInputStream(file).use { load(it, PASSWORD.toCharArray()) }
            folder.toFile().deleteRecursively()
        }
    }

    /** The fingerprint of its key, by which Chromium trusts it. */
    val fingerprint: String by lazy {
        Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(store.getCertificate(NAME).publicKey.encoded))
    }

    /** Returns the context with which a server uses the certificate. */
    fun context(): SSLContext = SSLContext.getInstance("TLS").apply {
        val keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm()).apply { init(store, PASSWORD.toCharArray()) }
        init(keys.keyManagers, null, null)
    }
}
