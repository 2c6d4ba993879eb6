#error the submission's own header was read instead of the contract
