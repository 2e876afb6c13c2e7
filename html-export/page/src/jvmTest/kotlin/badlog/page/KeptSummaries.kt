package badlog.page

/** Waits until the browser has stored the page's results so far. It stores them in the order in which it receives them. */
internal fun OpenPage.awaitKept() {
    driver.executeAsyncScript(
        """
        const done = arguments[0]
        indexedDB.open('badlog', 1).onsuccess = opened => {
            const database = opened.target.result, reading = database.transaction('logs')
            reading.objectStore('logs').count()
            reading.oncomplete = () => {
                database.close()
                done()
            }
        }
        """.trimIndent(),
    )
}
