;;; psdl-mode-test.el --- The mode and the server in a real Emacs -*- lexical-binding: t -*-

;;; Code:

(require 'package)
(package-initialize)
(require 'psdl-mode)

(setq eglot-sync-connect 10
      eglot-confirm-server-initiated-edits nil
      eglot-autoshutdown t)

(defvar psdl-test-passed 0)
(defvar psdl-test-failed 0)

(defmacro psdl-test (name &rest body)
  "Run BODY as the test NAME."
  (declare (indent 1))
  `(condition-case err
       (progn ,@body (setq psdl-test-passed (1+ psdl-test-passed)) (message "ok - %s" ,name))
     (error (setq psdl-test-failed (1+ psdl-test-failed)) (message "not ok - %s: %S" ,name err))))

(defmacro psdl-eventually (what condition)
  "Let Emacs work until CONDITION holds, and say that WHAT never was, else."
  `(with-timeout (10 (error "Never: %s" ,what))
     (let (value)
       (while (not (setq value ,condition)) (accept-process-output nil 0.05))
       value)))

(defun psdl-test-findings ()
  "The texts of the buffer's findings."
  ;; Changes are sent when Emacs is idle, which a batch never is.
  (eglot--signal-textDocument/didChange)
  (flymake-start)
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun psdl-test-open (name text)
  "Open a new file NAME with TEXT, with its server."
  (let ((file (expand-file-name name (make-temp-file "psdl" t))))
    (with-temp-file file (insert text))
    (find-file file)
    (call-interactively #'eglot)))

(defun psdl-test-scene (name)
  "The text of the scene NAME."
  (with-temp-buffer
    (insert-file-contents (expand-file-name name (getenv "PSDL_TEST_SCENES")))
    (buffer-string)))

(psdl-test "a .psdl file has the mode, and its faces"
  (psdl-test-open "lamp.psdl" (psdl-test-scene "lamp.psdl"))
  (cl-assert (eq major-mode 'psdl-mode))
  (font-lock-ensure)
  (goto-char (point-min))
  (search-forward "Object")
  (cl-assert (eq (get-text-property (match-beginning 0) 'face) 'font-lock-type-face))
  (search-forward "STANDING")
  (cl-assert (eq (get-text-property (match-beginning 0) 'face) 'font-lock-constant-face)))

(psdl-test "a finding stands at its statement"
  (psdl-eventually "a finding" (psdl-test-findings))
  (let ((finding (car (flymake-diagnostics))))
    (cl-assert (string-match-p "lamp floats 0.25 m above table" (flymake-diagnostic-text finding)))
    (goto-char (flymake-diagnostic-beg finding))
    (cl-assert (looking-at-p "lamp.min.z"))))

(psdl-test "findings follow typing"
  (goto-char (point-min))
  (search-forward "+ 0.25")
  (replace-match "+ 0.3")
  (psdl-eventually "the new finding"
                   (seq-some (lambda (text) (string-match-p "0.30 m" text)) (psdl-test-findings))))

(psdl-test "a quick fix mends a misspelt name"
  (goto-char (point-min))
  (search-forward "scene.center.x")
  (replace-match "scen.center.x")
  (psdl-eventually "the finding"
                   (seq-some (lambda (text) (string-match-p "scen" text)) (psdl-test-findings)))
  (goto-char (point-min))
  (search-forward "scen.")
  ;; There may be several: answer the question for one.
  (cl-letf (((symbol-function 'completing-read)
             (lambda (_prompt actions &rest _)
               (car (seq-find (lambda (action) (string-match-p "scene" (car action))) actions)))))
    (let ((last-nonmenu-event t))
      (eglot-code-actions (line-beginning-position) (line-end-position) "quickfix" t)))
  (psdl-eventually "the edit" (save-excursion (goto-char (point-min)) (search-forward "= scene.center.x" nil t))))

(psdl-test "psdl-fix corrects the lines of the region only"
  (goto-char (point-min))
  (psdl-fix (point-min) (line-beginning-position 6))
  ;; Nothing of those lines helps: only the lamp's own line would.
  (psdl-eventually "the finding" (psdl-test-findings))
  (cl-assert (save-excursion (goto-char (point-min)) (search-forward "+ 0.3" nil t))))

(psdl-test "psdl-fix corrects the program"
  (psdl-fix)
  (psdl-eventually "no finding" (null (psdl-test-findings)))
  (cl-assert (not (save-excursion (goto-char (point-min)) (search-forward "+ 0.3" nil t)))))

(set-buffer-modified-p nil)
(kill-buffer)

(message "%d passed, %d failed" psdl-test-passed psdl-test-failed)
(kill-emacs (if (zerop psdl-test-failed) 0 1))
;;; psdl-mode-test.el ends here
